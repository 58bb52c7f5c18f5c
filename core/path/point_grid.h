#pragma once

#include <cstdint>
#include <vector>

#include "math/types.h"

namespace stridegraph {

/// Points in a room that can be added to and asked for the nearest. Ties go to the point added first, so that
/// answers are the same everywhere.
class PointGrid {
 public:
  /// roomSize in metres; cells best hold a few points each.
  PointGrid(const Vec2& roomSize, double cellMetres);

  /// Adds a point inside the room; its index is the number of points before.
  void add(const Vec2& point);
  const std::vector<Vec2>& points() const { return points_; }

  /// Indices of the nearest points, nearest first; fewer when there are fewer.
  std::vector<std::uint32_t> nearest(const Vec2& point, std::size_t count) const;
  /// Indices of the points nearer than a distance, nearest first.
  std::vector<std::uint32_t> within(const Vec2& point, double metres) const;

 private:
  int cellIndex(double metres, int count) const;

  double cellMetres_;
  int columns_;
  int rows_;
  std::vector<Vec2> points_;
  std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace stridegraph
