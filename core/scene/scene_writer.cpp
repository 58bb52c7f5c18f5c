#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <string>

#include "scene/degrees.h"
#include "scene/json_text.h"
#include "scene/scene_json.h"
#include "scene/scene_members.h"
#include "scene/track_repeat.h"

namespace stridegraph {

namespace {

/// The shortest text that reads back as the same double; null, which no reader takes, for what JSON cannot
/// say.
std::string numberText(double value) {
  if (!std::isfinite(value)) return "null";
  // JSON readers take -0 for the whole number 0.
  return value == 0.0 && std::signbit(value) ? "-0.0" : fmt::format("{}", value);
}

std::string placementText(const Placement& placement) {
  std::string text = fmt::format(R"({{"x": {}, "z": {})", numberText(placement.position.x()),
                                 numberText(placement.position.y()));
  if (placement.heading) {
    text += fmt::format(R"(, "heading_deg": {})", numberText(degreesThatGive(*placement.heading)));
  }
  return text + "}";
}

std::string obstacleText(const Rectangle& obstacle) {
  return fmt::format(R"({{"x": {}, "z": {}, "width": {}, "depth": {}}})", numberText(obstacle.centre.x()),
                     numberText(obstacle.centre.y()), numberText(obstacle.size.x()),
                     numberText(obstacle.size.y()));
}

/// Texts one below the other, as a JSON list.
template <typename List, typename ToText>
std::string listText(const List& list, const ToText& toText) {
  std::string text = "[";
  for (const auto& element : list) {
    text += fmt::format("{}\n    {}", text.size() == 1 ? "" : ",", toText(element));
  }
  return text + (list.empty() ? "]" : "\n  ]");
}

std::string movingText(const MovingObstacle& moving) {
  std::string track;
  for (const TrackPoint& point : moving.track) {
    track += fmt::format(R"({}{{"t": {}, "x": {}, "z": {}}})", track.empty() ? "" : ", ",
                         numberText(point.seconds), numberText(point.position.x()),
                         numberText(point.position.y()));
  }
  return fmt::format(R"({{"width": {}, "depth": {}, "repeat": "{}", "track": [{}]}})",
                     numberText(moving.size.x()), numberText(moving.size.y()), trackRepeatName(moving.repeat),
                     track);
}

std::string jsonText(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string writeSceneJson(const Scene& scene) {
  std::string text = "{\n  \"version\": 1";
  const auto append = [&](std::string_view member, std::string_view value) {
    text += fmt::format(",\n  {}: {}", jsonText(Json(std::string(member))), value);
  };
  if (!scene.name.empty()) append("name", jsonText(Json(scene.name)));
  append("width", numberText(scene.widthMetres));
  append("depth", numberText(scene.depthMetres));
  append("obstacles", listText(scene.obstacles, obstacleText));
  if (!scene.moving.empty()) append("moving", listText(scene.moving, movingText));
  append("start", placementText(scene.start));
  append("goal", placementText(scene.goal));
  append("radius", numberText(scene.radiusMetres));
  append("seed", fmt::format("{}", scene.seed));
  if (!scene.unknownMembers.empty()) {
    const Result<Json> unknown = parseJson(scene.unknownMembers, "unknown members");
    if (unknown && unknown->is_object()) {
      for (const auto& [name, value] : unknown->items()) {
        if (!isKnownSceneMember(name)) append(name, jsonText(value));
      }
    }
  }
  return text + "\n}\n";
}

}  // namespace stridegraph
