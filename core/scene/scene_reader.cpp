#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "scene/json_text.h"
#include "scene/scene_json.h"
#include "scene/scene_limits.h"
#include "scene/scene_members.h"
#include "scene/track_repeat.h"

namespace stridegraph {

namespace {

constexpr std::uint64_t kVersion = 1;

tl::unexpected<Error> unexpectedValue(const std::string& place, const Json* found,
                                      std::string_view expected) {
  return fail(ErrorCode::kSceneValue, fmt::format("{}: found {}, expected {}", place,
                                                  found == nullptr ? "nothing" : quoted(*found), expected));
}

/// An object of the scene and its place in it, for messages.
class Member {
 public:
  Member(const Json& json, std::string place) : json_(&json), place_(std::move(place)) {}

  const Json& json() const { return *json_; }
  const std::string& place() const { return place_; }
  std::string placeOf(std::string_view name) const {
    return place_.empty() ? std::string(name) : fmt::format("{}.{}", place_, name);
  }
  const Json* find(std::string_view name) const {
    const auto found = json_->find(std::string(name));
    return found == json_->end() ? nullptr : &*found;
  }

  Result<double> number(std::string_view name) const {
    const Json* const value = find(name);
    if (value == nullptr || !value->is_number()) return unexpectedValue(placeOf(name), value, "a number");
    return value->get<double>();
  }
  Result<double> numberOr(std::string_view name, double otherwise) const {
    return find(name) == nullptr ? Result<double>(otherwise) : number(name);
  }
  Result<Vec2> pair(std::string_view first, std::string_view second) const {
    Result<double> x = number(first);
    if (!x) return fail(std::move(x));
    Result<double> y = number(second);
    if (!y) return fail(std::move(y));
    return Vec2(*x, *y);
  }
  Result<Member> object(std::string_view name) const {
    const Json* const value = find(name);
    if (value == nullptr || !value->is_object()) return unexpectedValue(placeOf(name), value, "an object");
    return Member(*value, placeOf(name));
  }

  /// Calls read(element) for each object of a list; stops at the first error.
  template <typename Read>
  Result<void> each(std::string_view name, std::size_t most, const Read& read) const {
    const Json* const list = find(name);
    if (list == nullptr || !list->is_array()) return unexpectedValue(placeOf(name), list, "a list");
    if (list->size() > most) {
      return fail(ErrorCode::kSceneValue, fmt::format("{}: found {} elements, expected at most {}",
                                                      placeOf(name), list->size(), most));
    }
    for (std::size_t i = 0; i < list->size(); ++i) {
      const Member element((*list)[i], fmt::format("{}[{}]", placeOf(name), i));
      if (!element.json().is_object()) return unexpectedValue(element.place(), &element.json(), "an object");
      if (Result<void> done = read(element); !done) return done;
    }
    return {};
  }

 private:
  const Json* json_;
  std::string place_;
};

Result<void> readVersion(const Member& scene) {
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

Result<std::string> readName(const Member& scene) {
  const Json* const name = scene.find("name");
  if (name == nullptr) return std::string();
  if (!name->is_string()) return unexpectedValue("name", name, "a text");
  return name->get<std::string>();
}

Result<std::uint64_t> readSeed(const Member& scene) {
  const Json* const seed = scene.find("seed");
  if (seed == nullptr) return Scene().seed;
  if (!seed->is_number_unsigned()) {
    return unexpectedValue("seed", seed, "a whole number from 0 to 18446744073709551615");
  }
  return seed->get<std::uint64_t>();
}

Result<Placement> readPlacement(const Member& scene, std::string_view name) {
  Result<Member> member = scene.object(name);
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

Result<void> readObstacle(const Member& member, Scene& scene) {
  Result<Vec2> centre = member.pair("x", "z");
  if (!centre) return fail(std::move(centre));
  Result<Vec2> size = member.pair("width", "depth");
  if (!size) return fail(std::move(size));
  scene.obstacles.push_back({*centre, *size});
  return {};
}

Result<TrackRepeat> readRepeat(const Member& member) {
  const Json* const name = member.find("repeat");
  if (name == nullptr) return TrackRepeat::kLoop;
  const std::optional<TrackRepeat> repeat =
      name->is_string() ? trackRepeatFromName(name->get<std::string>()) : std::nullopt;
  if (!repeat) return unexpectedValue(member.placeOf("repeat"), name, "\"loop\", \"pingpong\" or \"once\"");
  return *repeat;
}

Result<void> readMoving(const Member& member, Scene& scene) {
  MovingObstacle moving;
  Result<Vec2> size = member.pair("width", "depth");
  if (!size) return fail(std::move(size));
  moving.size = *size;
  Result<TrackRepeat> repeat = readRepeat(member);
  if (!repeat) return fail(std::move(repeat));
  moving.repeat = *repeat;
  Result<void> track = member.each("track", kMostTrackPoints, [&](const Member& element) -> Result<void> {
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

Result<void> readObstacles(const Member& member, Scene& scene) {
  Result<void> obstacles = member.each("obstacles", kMostObstacles,
                                       [&](const Member& element) { return readObstacle(element, scene); });
  if (!obstacles || member.find("moving") == nullptr) return obstacles;
  return member.each("moving", kMostObstacles,
                     [&](const Member& element) { return readMoving(element, scene); });
}

Result<void> readSizes(const Member& member, Scene& scene) {
  Result<Vec2> size = member.pair("width", "depth");
  if (!size) return fail(std::move(size));
  scene.widthMetres = size->x();
  scene.depthMetres = size->y();
  Result<double> radius = member.numberOr("radius", scene.radiusMetres);
  if (!radius) return fail(std::move(radius));
  scene.radiusMetres = *radius;
  return {};
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
  const Member member(json, "");
  Scene scene;
  if (Result<void> version = readVersion(member); !version) return fail(std::move(version));
  Result<std::string> name = readName(member);
  if (!name) return fail(std::move(name));
  scene.name = std::move(*name);
  if (Result<void> sizes = readSizes(member, scene); !sizes) return fail(std::move(sizes));
  if (Result<void> obstacles = readObstacles(member, scene); !obstacles) return fail(std::move(obstacles));
  Result<Placement> start = readPlacement(member, "start");
  if (!start) return fail(std::move(start));
  scene.start = *start;
  Result<Placement> goal = readPlacement(member, "goal");
  if (!goal) return fail(std::move(goal));
  scene.goal = *goal;
  Result<std::uint64_t> seed = readSeed(member);
  if (!seed) return fail(std::move(seed));
  scene.seed = *seed;
  scene.unknownMembers = unknownMembersOf(json);
  if (Result<void> checked = checkScene(scene); !checked) return fail(std::move(checked));
  return scene;
}

}  // namespace

Result<Scene> readSceneJson(std::string_view text, std::string_view name) {
  Result<Json> json = parseJson(text, name);
  if (!json) return fail(std::move(json));
  Result<Scene> scene = readMembers(*json);
  if (!scene) scene.error().place.file = std::string(name);
  return scene;
}

}  // namespace stridegraph
