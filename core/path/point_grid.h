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
  /// Calls visit(index) for the points nearer than a distance, cell by cell.
  template <typename Visit>
  void visitWithin(const Vec2& point, double metres, const Visit& visit) const;

 private:
  int cellIndex(double metres, int count) const;

  double cellMetres_;
  int columns_;
  int rows_;
  std::vector<Vec2> points_;
  std::vector<std::vector<std::uint32_t>> cells_;
};

template <typename Visit>
void PointGrid::visitWithin(const Vec2& point, double metres, const Visit& visit) const {
  const int lastRow = cellIndex(point.y() + metres, rows_);
  const int firstColumn = cellIndex(point.x() - metres, columns_);
  const int lastColumn = cellIndex(point.x() + metres, columns_);
  for (int r = cellIndex(point.y() - metres, rows_); r <= lastRow; ++r) {
    for (int c = firstColumn; c <= lastColumn; ++c) {
      for (const std::uint32_t index : cells_[static_cast<std::size_t>(r * columns_ + c)])
        if ((points_[index] - point).squaredNorm() < metres * metres) visit(index);
    }
  }
}

}  // namespace stridegraph
