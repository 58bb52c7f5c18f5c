#include "path/rectangle_grid.h"

#include <limits>

namespace stridegraph {

namespace {

constexpr double kSmallestCellMetres = 1.0;
constexpr double kMostCells = 160'000.0;
constexpr std::size_t kMostItems = 4'000'000;
/// Added to the reach, so that rounding in the walk over cells never skips a box that matters.
constexpr double kSlackMetres = 1e-3;

}  // namespace

RectangleGrid::RectangleGrid(std::span<const Box> boxes, const Vec2& roomSize, double reachMetres)
    : roomSize_(roomSize), reachMetres_(reachMetres) {
  chooseCellSize(boxes);
  fill(boxes);
  measureEmptyRings();
}

RectangleGrid::CellRange RectangleGrid::cellRange(const Box& box) const {
  return {column(box.minX), column(box.maxX), row(box.minZ), row(box.maxZ)};
}

bool RectangleGrid::insideRoom(const Box& box) const {
  return box.maxX >= 0.0 && box.maxZ >= 0.0 && box.minX <= roomSize_.x() && box.minZ <= roomSize_.y();
}

void RectangleGrid::chooseCellSize(std::span<const Box> boxes) {
  cellMetres_ = std::max(kSmallestCellMetres, std::sqrt(roomSize_.x() * roomSize_.y() / kMostCells));
  while (true) {
    inverseCell_ = 1.0 / cellMetres_;
    columns_ = std::max(1, static_cast<int>(std::ceil(roomSize_.x() * inverseCell_)));
    rows_ = std::max(1, static_cast<int>(std::ceil(roomSize_.y() * inverseCell_)));
    std::size_t items = 0;
    for (const Box& box : boxes) {
      const CellRange range = cellRange(grown(box, reachMetres_ + kSlackMetres));
      items += static_cast<std::size_t>(range.lastColumn - range.firstColumn + 1) *
               static_cast<std::size_t>(range.lastRow - range.firstRow + 1);
    }
    if (items <= kMostItems || (columns_ == 1 && rows_ == 1)) return;
    cellMetres_ *= 2.0;
  }
}

void RectangleGrid::fill(std::span<const Box> boxes) {
  const std::size_t cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  starts_.assign(cells + 1, 0);
  const auto forEachCell = [&](const auto& visit) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const Box reached = grown(boxes[i], reachMetres_ + kSlackMetres);
      if (!insideRoom(reached)) continue;
      const CellRange range = cellRange(reached);
      for (int r = range.firstRow; r <= range.lastRow; ++r) {
        for (int c = range.firstColumn; c <= range.lastColumn; ++c) visit(indexOf(c, r), i);
      }
    }
  };
  forEachCell([&](std::size_t cellIndex, std::size_t) { ++starts_[cellIndex + 1]; });
  for (std::size_t i = 0; i < cells; ++i) starts_[i + 1] += starts_[i];
  items_.resize(starts_[cells]);
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  forEachCell([&](std::size_t cellIndex, std::size_t box) {
    items_[next[cellIndex]++] = static_cast<std::uint32_t>(box);
  });
}

void RectangleGrid::measureEmptyRings() {
  constexpr std::uint16_t kFar = std::numeric_limits<std::uint16_t>::max();
  emptyRings_.assign(starts_.size() - 1, kFar);
  for (std::size_t i = 0; i < emptyRings_.size(); ++i) {
    if (starts_[i] != starts_[i + 1]) emptyRings_[i] = 0;
  }
  // Chessboard distance by two passes over the cells (Rosenfeld and Pfaltz 1968).
  const auto relax = [&](int c, int r, int dc, int dr) {
    if (c + dc < 0 || c + dc >= columns_ || r + dr < 0 || r + dr >= rows_) return;
    const std::uint16_t other = emptyRings_[indexOf(c + dc, r + dr)];
    std::uint16_t& mine = emptyRings_[indexOf(c, r)];
    if (other < kFar && other + 1 < mine) mine = static_cast<std::uint16_t>(other + 1);
  };
  for (int r = 0; r < rows_; ++r) {
    for (int c = 0; c < columns_; ++c) {
      relax(c, r, -1, 0);
      for (int dc = -1; dc <= 1; ++dc) relax(c, r, dc, -1);
    }
  }
  for (int r = rows_ - 1; r >= 0; --r) {
    for (int c = columns_ - 1; c >= 0; --c) {
      relax(c, r, 1, 0);
      for (int dc = -1; dc <= 1; ++dc) relax(c, r, dc, 1);
    }
  }
}

}  // namespace stridegraph
