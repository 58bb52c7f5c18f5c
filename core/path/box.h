#pragma once

#include <algorithm>
#include <cmath>

#include "math/types.h"
#include "scene/scene.h"

namespace stridegraph {

/// A rectangle by its corners: the form that distance tests want. Metres.
struct Box {
  double minX = 0.0;
  double minZ = 0.0;
  double maxX = 0.0;
  double maxZ = 0.0;
};

inline Box boxOf(const Rectangle& rectangle) {
  const Vec2 half = 0.5 * rectangle.size;
  return {rectangle.centre.x() - half.x(), rectangle.centre.y() - half.y(), rectangle.centre.x() + half.x(),
          rectangle.centre.y() + half.y()};
}

/// The box with every side moved outwards by `metres`.
inline Box grown(const Box& box, double metres) {
  return {box.minX - metres, box.minZ - metres, box.maxX + metres, box.maxZ + metres};
}

/// Squared distance of a point to the box; 0 inside.
inline double squaredDistance(const Box& box, const Vec2& point) {
  const double dx = std::max({box.minX - point.x(), point.x() - box.maxX, 0.0});
  const double dz = std::max({box.minZ - point.y(), point.y() - box.maxZ, 0.0});
  return dx * dx + dz * dz;
}

/// Distance of a point to the box's outline; negative inside.
inline double signedDistance(const Box& box, const Vec2& point) {
  const double dx = std::max(box.minX - point.x(), point.x() - box.maxX);
  const double dz = std::max(box.minZ - point.y(), point.y() - box.maxZ);
  if (dx <= 0.0 && dz <= 0.0) return std::max(dx, dz);
  return std::sqrt(squaredDistance(box, point));
}

/// Smallest distance between two boxes; 0 when they overlap.
inline double distanceBetween(const Box& a, const Box& b) {
  const double dx = std::max({a.minX - b.maxX, b.minX - a.maxX, 0.0});
  const double dz = std::max({a.minZ - b.maxZ, b.minZ - a.maxZ, 0.0});
  return std::sqrt(dx * dx + dz * dz);
}

/// Squared distance of a point to a segment.
double squaredDistanceToSegment(const Vec2& point, const Vec2& from, const Vec2& to);

/// Whether a segment comes nearer to the box than `radius`, i.e. enters the box's Minkowski sum with an open
/// disc: a rectangle with rounded corners.
bool segmentEntersGrownBox(const Box& box, double radius, const Vec2& from, const Vec2& to);

}  // namespace stridegraph
