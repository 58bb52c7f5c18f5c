#include "path/tangents.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace stridegraph {

namespace {

/// Rounding allowed when a tangent just touches a quarter's end or a circle's rim.
constexpr double kAngleSlackRadians = 1e-9;
constexpr double kAreaSlack = 1e-9;
constexpr double kMostOutsideMetres = 1e-3;
constexpr int kMostHalvings = 24;

double sign(Turn turn) {
  return turn == Turn::kCounterclockwise ? 1.0 : -1.0;
}

/// Turned by -90 degrees: what lies to the right when moving along v.
Vec2 rightOf(const Vec2& v) {
  return {v.y(), -v.x()};
}

/// The quarter's normals at its two ends, in the order in which this turn meets them.
std::pair<Vec2, Vec2> quarterEnds(const Corner& corner, Turn turn) {
  const Vec2 alongX(corner.outward.x(), 0.0);
  const Vec2 alongZ(0.0, corner.outward.y());
  const bool xFirst = (corner.outward.x() == corner.outward.y()) == (turn == Turn::kCounterclockwise);
  return xFirst ? std::pair(alongX, alongZ) : std::pair(alongZ, alongX);
}

bool appendHalved(const FloorPlan& plan, const Arc& arc, int halvings, std::vector<Vec2>& points) {
  const double middle = 0.5 * (arc.fromRadians + arc.toRadians);
  const double stretch = 1.0 / std::cos(0.5 * (arc.toRadians - arc.fromRadians));
  if ((stretch - 1.0) * arc.radiusMetres <= kMostOutsideMetres) {
    const Vec2 outside = pointOnArc(arc, middle, stretch);
    const Vec2 end = pointOnArc(arc, arc.toRadians);
    if (plan.isFree(points.back(), outside) && plan.isFree(outside, end)) {
      points.push_back(outside);
      points.push_back(end);
      return true;
    }
    if (halvings == 0 || !plan.isFree(pointOnArc(arc, middle))) return false;
  }
  Arc first = arc;
  first.toRadians = middle;
  Arc second = arc;
  second.fromRadians = middle;
  return appendHalved(plan, first, halvings - 1, points) && appendHalved(plan, second, halvings - 1, points);
}

}  // namespace

std::optional<Tangent> tangentBetween(const TangentCircle& from, const TangentCircle& to) {
  const Vec2 apart = to.centre - from.centre;
  const double squaredDistance = apart.squaredNorm();
  const double side = from.radiusMetres * sign(from.turn) - to.radiusMetres * sign(to.turn);
  const double squaredSide = side * side;
  if (squaredDistance == 0.0 || squaredSide > squaredDistance + kAreaSlack) return std::nullopt;
  // apart = length * along + side * rightOf(along), solved for the unit vector along.
  const double length = std::sqrt(std::max(squaredDistance - squaredSide, 0.0));
  const Vec2 along = (length * apart - side * rightOf(apart)) / squaredDistance;
  const Vec2 right = rightOf(along);
  return Tangent{from.centre + from.radiusMetres * sign(from.turn) * right,
                 to.centre + to.radiusMetres * sign(to.turn) * right, right};
}

double angleAlongQuarter(const Corner& corner, Turn turn, const Vec2& normal) {
  const auto [first, last] = quarterEnds(corner, turn);
  return std::clamp(std::atan2(normal.dot(last), normal.dot(first)), 0.0, 0.5 * std::numbers::pi);
}

Vec2 pointOnArc(const Arc& arc, double radians, double factor) {
  const auto [first, last] = quarterEnds(arc.corner, arc.turn);
  return arc.corner.centre +
         factor * arc.radiusMetres * (std::cos(radians) * first + std::sin(radians) * last);
}

bool appendArc(const FloorPlan& plan, const Arc& arc, std::vector<Vec2>& points) {
  if (arc.toRadians - arc.fromRadians < kAngleSlackRadians) return true;
  const std::size_t firstAdded = points.size();
  points.push_back(pointOnArc(arc, arc.fromRadians));
  if (!appendHalved(plan, arc, kMostHalvings, points)) return false;
  // Points on the circle lie on the straight lines between their neighbours outside it: all but the last go.
  std::size_t kept = firstAdded;
  for (std::size_t i = firstAdded + 1; i + 1 < points.size(); i += 2) points[kept++] = points[i];
  points[kept++] = points.back();
  points.resize(kept);
  return true;
}

}  // namespace stridegraph
