#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "path/box.h"

namespace stridegraph {

/// What a cell of a room says about a disc whose centre lies in it.
enum class Occupancy : std::uint8_t { kFree, kMixed, kBlocked };

/// A fine grid over a room that answers most "may the disc stand here?" by one look-up. A cell is free or
/// blocked only when that holds for every point in it, rounding included; else it is mixed and wants the
/// exact test.
class OccupancyMap {
 public:
  /// A point is blocked when it is nearer than `distanceMetres` to a box or wall. Cells are 0.1 m, larger in
  /// rooms above 40,000 m2.
  OccupancyMap(std::span<const Box> boxes, const Vec2& roomSize, double distanceMetres);

  /// Outside the room everything is blocked; so is a point that is not a number.
  Occupancy at(const Vec2& point) const {
    const double column = point.x() * inverseCell_;
    const double row = point.y() * inverseCell_;
    if (!(column >= 0.0 && row >= 0.0 && column < columns_ && row < rows_)) return Occupancy::kBlocked;
    return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
  }

  /// The cells under a line along x, from x = 0 on; the line lies in the room.
  std::span<const Occupancy> rowUnder(double z) const {
    const auto row = static_cast<std::size_t>(std::min(z * inverseCell_, rows_ - 0.5));
    const auto columns = static_cast<std::size_t>(columns_);
    return std::span(cells_).subspan(row * columns, columns);
  }

  double cellMetres() const { return cellMetres_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }

 private:
  void markWalls(const Vec2& roomSize, double distanceMetres);
  void markBox(const Box& box, double distanceMetres);
  struct ColumnRange {
    int first, last;
  };
  Occupancy* cellsOf(int row);
  void markMixed(int row, const ColumnRange& columns);

  double cellMetres_;
  double inverseCell_;
  int columns_;
  int rows_;
  std::vector<Occupancy> cells_;
};

}  // namespace stridegraph
