#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "path/box.h"

namespace stridegraph {

/// Square cells over a room, each with the boxes that come near it: turns a question about all boxes into one
/// about a few. Built once, never changed.
class RectangleGrid {
 public:
  /// Lists every box in the cells that the box, grown by `reachMetres`, overlaps. Cells are 1 m; larger when
  /// the room is vast or the lists would grow beyond a few million entries.
  RectangleGrid(std::span<const Box> boxes, const Vec2& roomSize, double reachMetres);

  /// The boxes within reach of the cell that holds the point, and perhaps a few more. A point outside the
  /// room counts as one on its edge.
  std::span<const std::uint32_t> candidates(const Vec2& point) const {
    return cell(column(point.x()), row(point.y()));
  }

  /// Calls visit(span of candidates) for every cell that a segment inside the room passes, in order, until
  /// visit returns true. Returns whether it did.
  template <typename Visit>
  bool anyCellAlong(const Vec2& from, const Vec2& to, const Visit& visit) const;

  /// Calls visit(span of candidates) for cells in growing rings around the point. `boundMetres` is the answer
  /// so far: rings that only hold boxes further away are not visited. visit returns the new bound.
  template <typename Visit>
  void ringsAround(const Vec2& point, double boundMetres, const Visit& visit) const;

  /// Calls visit(span) for every cell that the box overlaps.
  template <typename Visit>
  void cellsOf(const Box& box, const Visit& visit) const;

 private:
  int column(double x) const { return clampedIndex(x, columns_); }
  int row(double z) const { return clampedIndex(z, rows_); }
  int clampedIndex(double metres, int count) const {
    const double index = metres * inverseCell_;
    return index > 0.0 ? (index < count ? static_cast<int>(index) : count - 1) : 0;
  }
  std::size_t indexOf(int c, int r) const {
    return static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c);
  }
  std::span<const std::uint32_t> cell(int c, int r) const {
    const std::size_t index = indexOf(c, r);
    return {items_.data() + starts_[index], items_.data() + starts_[index + 1]};
  }
  struct CellRange {
    int firstColumn, lastColumn, firstRow, lastRow;
  };
  CellRange cellRange(const Box& box) const;
  bool insideRoom(const Box& box) const;
  void chooseCellSize(std::span<const Box> boxes);
  void fill(std::span<const Box> boxes);
  void measureEmptyRings();

  Vec2 roomSize_;
  double reachMetres_;
  double cellMetres_ = 1.0;
  double inverseCell_ = 1.0;
  int columns_ = 1;
  int rows_ = 1;
  std::vector<std::uint32_t> starts_;
  std::vector<std::uint32_t> items_;
  std::vector<std::uint16_t>
      emptyRings_;  ///< For each cell: how many rings around it, itself first, are empty.
};

template <typename Visit>
bool RectangleGrid::anyCellAlong(const Vec2& from, const Vec2& to, const Visit& visit) const {
  int c = column(from.x());
  int r = row(from.y());
  const int lastColumn = column(to.x());
  const int lastRow = row(to.y());
  const Vec2 along = to - from;
  const int stepColumn = along.x() > 0.0 ? 1 : -1;
  const int stepRow = along.y() > 0.0 ? 1 : -1;
  // Fractions of the segment at which it crosses into the next column and row (Amanatides and Woo 1987).
  const auto crossing = [&](double origin, double delta, int index, int step) {
    return delta == 0.0 ? 2.0 : ((index + (step > 0 ? 1 : 0)) * cellMetres_ - origin) / delta;
  };
  while (true) {
    if (visit(cell(c, r))) return true;
    if (c == lastColumn && r == lastRow) return false;
    const double nextColumn = c == lastColumn ? 3.0 : crossing(from.x(), along.x(), c, stepColumn);
    const double nextRow = r == lastRow ? 3.0 : crossing(from.y(), along.y(), r, stepRow);
    if (nextColumn < nextRow) {
      c += stepColumn;
    } else {
      r += stepRow;
    }
  }
}

template <typename Visit>
void RectangleGrid::ringsAround(const Vec2& point, double boundMetres, const Visit& visit) const {
  const int c = column(point.x());
  const int r = row(point.y());
  const int rings = std::max(columns_, rows_);
  double bound = boundMetres;
  for (int ring = emptyRings_[indexOf(c, r)]; ring < rings; ++ring) {
    // Boxes seen only from this ring on lie beyond all rings before, and are listed within reach.
    if (ring > 0 && (ring - 1) * cellMetres_ + reachMetres_ >= bound) return;
    const int firstRow = std::max(r - ring, 0);
    const int lastRow = std::min(r + ring, rows_ - 1);
    for (int y = firstRow; y <= lastRow; ++y) {
      const bool wholeRow = y == r - ring || y == r + ring;
      const int step = wholeRow || ring == 0 ? 1 : 2 * ring;
      for (int x = c - ring; x <= c + ring; x += step) {
        if (x >= 0 && x < columns_) bound = visit(cell(x, y));
      }
    }
  }
}

template <typename Visit>
void RectangleGrid::cellsOf(const Box& box, const Visit& visit) const {
  const CellRange range = cellRange(box);
  for (int y = range.firstRow; y <= range.lastRow; ++y) {
    for (int x = range.firstColumn; x <= range.lastColumn; ++x) visit(cell(x, y));
  }
}

}  // namespace stridegraph
