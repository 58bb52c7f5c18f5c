#include "path/point_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stridegraph {

namespace {

constexpr double kMostCells = 250'000.0;

}  // namespace

PointGrid::PointGrid(const Vec2& roomSize, double cellMetres)
    : cellMetres_(std::max(cellMetres, std::sqrt(roomSize.x() * roomSize.y() / kMostCells))),
      columns_(std::max(1, static_cast<int>(std::ceil(roomSize.x() / cellMetres_)))),
      rows_(std::max(1, static_cast<int>(std::ceil(roomSize.y() / cellMetres_)))),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

int PointGrid::cellIndex(double metres, int count) const {
  return static_cast<int>(std::clamp(std::floor(metres / cellMetres_), 0.0, static_cast<double>(count - 1)));
}

void PointGrid::add(const Vec2& point) {
  const int cell = cellIndex(point.y(), rows_) * columns_ + cellIndex(point.x(), columns_);
  cells_[static_cast<std::size_t>(cell)].push_back(static_cast<std::uint32_t>(points_.size()));
  points_.push_back(point);
}

std::vector<std::uint32_t> PointGrid::nearest(const Vec2& point, std::size_t count) const {
  const int column = cellIndex(point.x(), columns_);
  const int row = cellIndex(point.y(), rows_);
  std::vector<std::pair<double, std::uint32_t>> found;
  const std::size_t wanted = std::min(count, points_.size());
  for (int ring = 0; ring < std::max(columns_, rows_); ++ring) {
    for (int r = std::max(row - ring, 0); r <= std::min(row + ring, rows_ - 1); ++r) {
      const bool wholeRow = r == row - ring || r == row + ring;
      for (int c = column - ring; c <= column + ring; c += wholeRow || ring == 0 ? 1 : 2 * ring) {
        if (c < 0 || c >= columns_) continue;
        for (const std::uint32_t index : cells_[static_cast<std::size_t>(r * columns_ + c)]) {
          found.emplace_back((points_[index] - point).squaredNorm(), index);
        }
      }
    }
    if (found.size() < wanted) continue;
    // Points in rings to come are at least this far away.
    const double seen = ring * cellMetres_;
    const auto isSeen = [&](const auto& candidate) { return candidate.first < seen * seen; };
    if (static_cast<std::size_t>(std::count_if(found.begin(), found.end(), isSeen)) >= wanted) break;
  }
  std::sort(found.begin(), found.end());
  std::vector<std::uint32_t> indices;
  for (std::size_t i = 0; i < std::min(wanted, found.size()); ++i) indices.push_back(found[i].second);
  return indices;
}

}  // namespace stridegraph
