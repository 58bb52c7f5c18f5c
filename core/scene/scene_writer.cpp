#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <string>

#include "scene/degrees.h"
#include "scene/json_text.h"
#include "scene/scene_json.h"
#include "scene/scene_members.h"
#include "scene/scene_names.h"

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

/// The members of a rectangle, without braces.
std::string rectangleMembers(const Rectangle& rectangle) {
  return fmt::format(R"("x": {}, "z": {}, "width": {}, "depth": {})", numberText(rectangle.centre.x()),
                     numberText(rectangle.centre.y()), numberText(rectangle.size.x()),
                     numberText(rectangle.size.y()));
}

std::string obstacleText(const Rectangle& obstacle) {
  return fmt::format("{{{}}}", rectangleMembers(obstacle));
}

std::string areaText(const Area& area) {
  return fmt::format(R"({{{}, "kind": "{}"}})", rectangleMembers(area.rectangle), areaKindName(area.kind));
}

std::string walkerText(const Walker& walker) {
  return fmt::format(R"({{"start": {}, "goal": {}}})", placementText(walker.start),
                     placementText(walker.goal));
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

std::string constraintsText(const WalkConstraints& constraints) {
  std::string text;
  const auto append = [&](std::string_view member, std::string_view value) {
    text += fmt::format("{}\"{}\": {}", text.empty() ? "" : ", ", member, value);
  };
  if (constraints.gait) append("gait", fmt::format("\"{}\"", gaitName(*constraints.gait)));
  if (constraints.minSpeedMetresPerSecond) {
    append("min_speed_m_s", numberText(*constraints.minSpeedMetresPerSecond));
  }
  if (constraints.maxSpeedMetresPerSecond) {
    append("max_speed_m_s", numberText(*constraints.maxSpeedMetresPerSecond));
  }
  if (constraints.latestArrivalSeconds) {
    append("latest_arrival_s", numberText(*constraints.latestArrivalSeconds));
  }
  if (!constraints.areas.empty()) append("areas", listText(constraints.areas, areaText));
  return fmt::format("{{{}}}", text);
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
  if (!scene.walkers.empty()) append("walkers", listText(scene.walkers, walkerText));
  if (scene.constraints.any()) append("constraints", constraintsText(scene.constraints));
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
