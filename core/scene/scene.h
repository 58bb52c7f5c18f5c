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
};

/// A place on the floor with or without a direction.
struct Placement {
  Vec2 position = Vec2::Zero();
  std::optional<Angle> heading;
};

/// Where a moving obstacle's centre is at a time.
struct TrackPoint {
  double seconds = 0.0;
  Vec2 position = Vec2::Zero();
};

enum class TrackRepeat { kLoop, kPingPong, kOnce };

/// A rectangle that follows a known track.
struct MovingObstacle {
  Vec2 size = Vec2::Ones();
  TrackRepeat repeat = TrackRepeat::kLoop;
  std::vector<TrackPoint> track;  ///< At least one; times grow.
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
  double radiusMetres = 0.4;  ///< Of the disc that stands for the body, > 0.
  std::uint64_t seed = 1;
  /// Members of the JSON that this version does not know, kept as a JSON object text; empty when there are
  /// none.
  std::string unknownMembers;
};

}  // namespace stridegraph
