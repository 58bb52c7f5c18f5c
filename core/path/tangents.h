#pragma once

#include <optional>
#include <vector>

#include "math/types.h"
#include "path/floor_plan.h"

namespace stridegraph {

/// Which way a path turns around a corner, seen with x to the right and z up.
enum class Turn { kClockwise, kCounterclockwise };

/// The rounded corner of a grown rectangle: a quarter of a circle.
struct Corner {
  Vec2 centre = Vec2::Zero();
  Vec2 outward = Vec2::Ones();  ///< Signs: the quarter's normals lie between (x, 0) and (0, z).
};

/// A circle to be tangent to: a corner's with a turn, or a point (radius 0).
struct TangentCircle {
  Vec2 centre = Vec2::Zero();
  double radiusMetres = 0.0;
  Turn turn = Turn::kClockwise;
};

/// The segment that leaves one circle in its turn and joins the other in its own.
struct Tangent {
  Vec2 from = Vec2::Zero();
  Vec2 to = Vec2::Zero();
  Vec2 right = Vec2::Zero();  ///< Unit vector to the right of its direction.
};

/// Nothing when one circle lies too deep in the other.
std::optional<Tangent> tangentBetween(const TangentCircle& from, const TangentCircle& to);

/// The normal, away from the circle's centre, at which a tangent touches a circle with this turn.
inline Vec2 touchingNormal(const Tangent& tangent, Turn turn) {
  return turn == Turn::kCounterclockwise ? tangent.right : Vec2(-tangent.right);
}

/// Whether a normal lies in a corner's quarter, ends included.
inline bool liesOnQuarter(const Corner& corner, const Vec2& normal) {
  constexpr double kSlack = 1e-9;
  return normal.x() * corner.outward.x() >= -kSlack && normal.y() * corner.outward.y() >= -kSlack;
}

/// How far a normal of the quarter lies from the end at which a path with this turn enters it: 0 to pi/2
/// radians.
double angleAlongQuarter(const Corner& corner, Turn turn, const Vec2& normal);

/// A piece of a corner's quarter.
struct Arc {
  Corner corner;
  Turn turn = Turn::kClockwise;
  double radiusMetres = 0.0;
  double fromRadians = 0.0;  ///< Along the quarter, as angleAlongQuarter says.
  double toRadians = 0.0;
};

/// The point on an arc's circle at an angle along the quarter, on a circle larger by `factor`.
Vec2 pointOnArc(const Arc& arc, double radians, double factor = 1.0);

/// Appends points that follow the arc from outside, after its first point and with its last: corners of the
/// tangents between points on the arc, at most 1 mm outside, nearer where another obstacle is that close.
/// False, with points in an unspecified state, when the disc cannot follow the arc.
bool appendArc(const FloorPlan& plan, const Arc& arc, std::vector<Vec2>& points);

}  // namespace stridegraph
