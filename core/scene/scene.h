#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "math/angle.h"
#include "math/types.h"

namespace stridegraph {

/// A rectangle on the floor, sides along x and z, tall enough that nobody steps over it.
struct Rectangle {
  Vec2 centre = Vec2::Zero();  ///< x, z in metres.
  Vec2 size = Vec2::Ones();    ///< Full width along x and depth along z, metres, > 0.

  bool operator==(const Rectangle&) const = default;
};

/// A place on the floor with or without a direction.
struct Placement {
  Vec2 position = Vec2::Zero();
  std::optional<Angle> heading;

  bool operator==(const Placement&) const = default;
};

/// Where a moving obstacle's centre is at a time.
struct TrackPoint {
  double seconds = 0.0;
  Vec2 position = Vec2::Zero();

  bool operator==(const TrackPoint&) const = default;
};

enum class TrackRepeat { kLoop, kPingPong, kOnce };

/// A rectangle that follows a known track.
struct MovingObstacle {
  Vec2 size = Vec2::Ones();
  TrackRepeat repeat = TrackRepeat::kLoop;
  std::vector<TrackPoint> track;  ///< At least one; times grow.

  bool operator==(const MovingObstacle&) const = default;
};

/// A further walker beside the scene's first one.
struct Walker {
  Placement start;
  Placement goal;

  bool operator==(const Walker&) const = default;
};

enum class Gait { kWalk, kRun };

enum class AreaKind { kAvoid, kPrefer };

/// A part of the floor that walks keep out of where they can, or lead over where that costs little.
struct Area {
  Rectangle rectangle;
  AreaKind kind = AreaKind::kAvoid;

  bool operator==(const Area&) const = default;
};

/// What every walk of a scene keeps to, beyond getting there (Alankus 2005, 4.2.2). Nothing set: anything
/// goes.
struct WalkConstraints {
  std::optional<Gait> gait;
  std::optional<double> minSpeedMetresPerSecond;  ///< 0..10, at most the greatest speed.
  std::optional<double> maxSpeedMetresPerSecond;  ///< 0..10.
  std::optional<double> latestArrivalSeconds;     ///< After the walk's beginning, above 0, at most 3600.
  std::vector<Area> areas;

  bool asksForPace() const { return gait || minSpeedMetresPerSecond || maxSpeedMetresPerSecond; }
  bool any() const { return asksForPace() || latestArrivalSeconds || !areas.empty(); }
  bool operator==(const WalkConstraints&) const = default;
};

/// A room to walk in: what users draw, save, and share. The room spans 0..width in x and 0..depth in z.
struct Scene {
  std::string name;
  double widthMetres = 12.0;
  double depthMetres = 12.0;
  std::vector<Rectangle> obstacles;
  std::vector<MovingObstacle> moving;
  Placement start;
  Placement goal;
  std::vector<Walker> walkers;  ///< Further ones; start and goal above are the first walker's.
  WalkConstraints constraints;
  double radiusMetres = 0.4;  ///< Of the disc that stands for the body, > 0.
  std::uint64_t seed = 1;
  /// Members of the JSON that this version does not know, kept as a JSON object text; empty when there are
  /// none.
  std::string unknownMembers;
};

}  // namespace stridegraph
