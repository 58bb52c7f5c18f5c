#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "scene/json_member.h"
#include "scene/json_text.h"
#include "scene/scene_encoding.h"
#include "scene/scene_json.h"
#include "scene/scene_limits.h"
#include "scene/scene_members.h"
#include "scene/scene_names.h"
#include "scene/scene_notes.h"

namespace stridegraph {

namespace {

constexpr std::uint64_t kVersion = 1;

Result<void> readVersion(const JsonMember& scene) {
  const Json* const version = scene.find("version");
  if (version == nullptr) return {};
  if (!version->is_number_unsigned() || version->get<std::uint64_t>() == 0) {
    return unexpectedValue("version", version, "1");
  }
  if (version->get<std::uint64_t>() > kVersion) {
    return unexpectedValue("version", version, "1: the scene was made by a newer program");
  }
  return {};
}

Result<std::string> readName(const JsonMember& scene) {
  const Json* const name = scene.find("name");
  if (name == nullptr) return std::string();
  if (!name->is_string()) return unexpectedValue("name", name, "a text");
  return name->get<std::string>();
}

Result<std::uint64_t> readSeed(const JsonMember& scene) {
  const Json* const seed = scene.find("seed");
  if (seed == nullptr) return Scene().seed;
  if (!seed->is_number_unsigned()) {
    return unexpectedValue("seed", seed, "a whole number from 0 to 18446744073709551615");
  }
  return seed->get<std::uint64_t>();
}

Result<Placement> readPlacement(const JsonMember& parent, std::string_view name) {
  Result<JsonMember> member = parent.object(name);
  if (!member) return fail(std::move(member));
  Result<Vec2> position = member->pair("x", "z");
  if (!position) return fail(std::move(position));
  Placement placement{*position, std::nullopt};
  if (member->find("heading_deg") != nullptr) {
    Result<double> degrees = member->number("heading_deg");
    if (!degrees) return fail(std::move(degrees));
    placement.heading = Angle::degrees(*degrees);
  }
  return placement;
}

Result<Rectangle> readRectangle(const JsonMember& member) {
  Result<Vec2> centre = member.pair("x", "z");
  if (!centre) return fail(std::move(centre));
  Result<Vec2> size = member.pair("width", "depth");
  if (!size) return fail(std::move(size));
  return Rectangle{*centre, *size};
}

Result<void> readObstacle(const JsonMember& member, Scene& scene) {
  Result<Rectangle> rectangle = readRectangle(member);
  if (!rectangle) return fail(std::move(rectangle));
  scene.obstacles.push_back(*rectangle);
  return {};
}

/// The value of an enumeration that the member's text names.
template <typename Enum>
Result<Enum> readNamed(const JsonMember& member, std::string_view name,
                       std::optional<Enum> (*fromName)(std::string_view), std::string_view expected) {
  const Json* const text = member.find(name);
  const std::optional<Enum> value =
      text != nullptr && text->is_string() ? fromName(text->get<std::string>()) : std::nullopt;
  if (!value) return unexpectedValue(member.placeOf(name), text, expected);
  return *value;
}

Result<void> readMoving(const JsonMember& member, Scene& scene) {
  MovingObstacle moving;
  Result<Vec2> size = member.pair("width", "depth");
  if (!size) return fail(std::move(size));
  moving.size = *size;
  if (member.find("repeat") != nullptr) {
    Result<TrackRepeat> repeat =
        readNamed(member, "repeat", trackRepeatFromName, "\"loop\", \"pingpong\" or \"once\"");
    if (!repeat) return fail(std::move(repeat));
    moving.repeat = *repeat;
  }
  Result<void> track = member.each("track", kMostTrackPoints, [&](const JsonMember& element) -> Result<void> {
    Result<double> seconds = element.number("t");
    if (!seconds) return fail(std::move(seconds));
    Result<Vec2> position = element.pair("x", "z");
    if (!position) return fail(std::move(position));
    moving.track.push_back({*seconds, *position});
    return {};
  });
  if (!track) return track;
  scene.moving.push_back(std::move(moving));
  return {};
}

Result<void> readObstacles(const JsonMember& member, Scene& scene) {
  Result<void> obstacles = member.each(
      "obstacles", kMostObstacles, [&](const JsonMember& element) { return readObstacle(element, scene); });
  if (!obstacles || member.find("moving") == nullptr) return obstacles;
  return member.each("moving", kMostObstacles,
                     [&](const JsonMember& element) { return readMoving(element, scene); });
}

Result<void> readSizes(const JsonMember& member, Scene& scene) {
  Result<Vec2> size = member.pair("width", "depth");
  if (!size) return fail(std::move(size));
  scene.widthMetres = size->x();
  scene.depthMetres = size->y();
  Result<double> radius = member.numberOr("radius", scene.radiusMetres);
  if (!radius) return fail(std::move(radius));
  scene.radiusMetres = *radius;
  return {};
}

Result<void> readWalker(const JsonMember& member, Scene& scene) {
  Result<Placement> start = readPlacement(member, "start");
  if (!start) return fail(std::move(start));
  Result<Placement> goal = readPlacement(member, "goal");
  if (!goal) return fail(std::move(goal));
  scene.walkers.push_back({*start, *goal});
  return {};
}

Result<void> readWalkers(const JsonMember& member, Scene& scene) {
  Result<Placement> start = readPlacement(member, "start");
  if (!start) return fail(std::move(start));
  scene.start = *start;
  Result<Placement> goal = readPlacement(member, "goal");
  if (!goal) return fail(std::move(goal));
  scene.goal = *goal;
  if (member.find("walkers") == nullptr) return {};
  return member.each("walkers", kMostWalkers,
                     [&](const JsonMember& element) { return readWalker(element, scene); });
}

Result<void> readOptional(const JsonMember& member, std::string_view name, std::optional<double>& value) {
  if (member.find(name) == nullptr) return {};
  Result<double> number = member.number(name);
  if (!number) return fail(std::move(number));
  value = *number;
  return {};
}

Result<void> readArea(const JsonMember& member, WalkConstraints& constraints) {
  Result<Rectangle> rectangle = readRectangle(member);
  if (!rectangle) return fail(std::move(rectangle));
  Result<AreaKind> kind = readNamed(member, "kind", areaKindFromName, "\"avoid\" or \"prefer\"");
  if (!kind) return fail(std::move(kind));
  constraints.areas.push_back({*rectangle, *kind});
  return {};
}

Result<void> readConstraints(const JsonMember& scene, WalkConstraints& constraints) {
  if (scene.find("constraints") == nullptr) return {};
  Result<JsonMember> member = scene.object("constraints");
  if (!member) return fail(std::move(member));
  if (member->find("gait") != nullptr) {
    Result<Gait> gait = readNamed(*member, "gait", gaitFromName, "\"walk\" or \"run\"");
    if (!gait) return fail(std::move(gait));
    constraints.gait = *gait;
  }
  if (Result<void> least = readOptional(*member, "min_speed_m_s", constraints.minSpeedMetresPerSecond);
      !least) {
    return least;
  }
  if (Result<void> most = readOptional(*member, "max_speed_m_s", constraints.maxSpeedMetresPerSecond);
      !most) {
    return most;
  }
  if (Result<void> arrival = readOptional(*member, "latest_arrival_s", constraints.latestArrivalSeconds);
      !arrival) {
    return arrival;
  }
  if (member->find("areas") == nullptr) return {};
  return member->each("areas", kMostAreas,
                      [&](const JsonMember& element) { return readArea(element, constraints); });
}

std::string unknownMembersOf(const Json& json) {
  Json unknown = Json::object();
  for (const auto& [name, value] : json.items()) {
    if (!isKnownSceneMember(name)) unknown[name] = value;
  }
  return unknown.empty() ? std::string() : unknown.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<Scene> readMembers(const Json& json) {
  if (!json.is_object()) return unexpectedValue("scene", &json, "an object");
  const JsonMember member(json, "");
  Scene scene;
  if (Result<void> version = readVersion(member); !version) return fail(std::move(version));
  Result<std::string> name = readName(member);
  if (!name) return fail(std::move(name));
  scene.name = std::move(*name);
  if (Result<void> sizes = readSizes(member, scene); !sizes) return fail(std::move(sizes));
  if (Result<void> obstacles = readObstacles(member, scene); !obstacles) return fail(std::move(obstacles));
  if (Result<void> walkers = readWalkers(member, scene); !walkers) return fail(std::move(walkers));
  if (Result<void> read = readConstraints(member, scene.constraints); !read) return fail(std::move(read));
  Result<std::uint64_t> seed = readSeed(member);
  if (!seed) return fail(std::move(seed));
  scene.seed = *seed;
  scene.unknownMembers = unknownMembersOf(json);
  if (Result<void> checked = checkScene(scene); !checked) return fail(std::move(checked));
  return scene;
}

}  // namespace

Result<Scene> readSceneJson(std::string_view text, std::string_view name, Warnings* notes) {
  if (Result<void> encoding = checkSceneEncoding(text, name); !encoding) return fail(std::move(encoding));
  Result<Json> json = parseJson(text, name);
  if (!json) return fail(std::move(json));
  if (notes != nullptr) {
    Warnings found = sceneNotes(text, name);
    notes->insert(notes->end(), std::make_move_iterator(found.begin()), std::make_move_iterator(found.end()));
  }
  Result<Scene> scene = readMembers(*json);
  if (!scene) scene.error().place.file = std::string(name);
  return scene;
}

}  // namespace stridegraph
