#include "path/occupancy_map.h"

namespace stridegraph {

namespace {

constexpr double kSmallestCellMetres = 0.1;
constexpr double kMostCells = 4'000'000.0;
/// Cells this near to a border count as mixed: far above rounding in rooms of up to 1 km.
constexpr double kSlackMetres = 1e-9;

/// Half the width of the grown box's round end at this distance from the box's side.
double halfWidth(double radius, double offset) {
  return std::sqrt(radius * radius - offset * offset);
}

int floorToInt(double value, int low, int high) {
  const double within = std::clamp(value, static_cast<double>(low), static_cast<double>(high));
  const int truncated = static_cast<int>(within);
  return within < truncated ? truncated - 1 : truncated;
}

}  // namespace

OccupancyMap::OccupancyMap(std::span<const Box> boxes, const Vec2& roomSize, double distanceMetres)
    : cellMetres_(std::max(kSmallestCellMetres, std::sqrt(roomSize.x() * roomSize.y() / kMostCells))),
      inverseCell_(1.0 / cellMetres_),
      columns_(static_cast<int>(std::ceil(roomSize.x() * inverseCell_))),
      rows_(static_cast<int>(std::ceil(roomSize.y() * inverseCell_))) {
  markWalls(roomSize, distanceMetres);
  for (const Box& box : boxes) markBox(box, distanceMetres);
}

Occupancy* OccupancyMap::cellsOf(int row) {
  return cells_.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
}

void OccupancyMap::markMixed(int row, const ColumnRange& columns) {
  Occupancy* const cells = cellsOf(row);
  for (int c = columns.first; c <= columns.last; ++c) cells[c] = std::max(cells[c], Occupancy::kMixed);
}

void OccupancyMap::markWalls(const Vec2& roomSize, double distanceMetres) {
  const auto stripState = [&](int index, double size) {
    const double low = index * cellMetres_;
    const double high = low + cellMetres_;
    const double border = distanceMetres;
    if (high < border - kSlackMetres || low > size - border + kSlackMetres) return Occupancy::kBlocked;
    if (low < border + kSlackMetres || high > size - border - kSlackMetres) return Occupancy::kMixed;
    return Occupancy::kFree;
  };
  std::vector<Occupancy> columnStates(static_cast<std::size_t>(columns_));
  for (int c = 0; c < columns_; ++c) columnStates[static_cast<std::size_t>(c)] = stripState(c, roomSize.x());
  cells_.reserve(columnStates.size() * static_cast<std::size_t>(rows_));
  for (int r = 0; r < rows_; ++r) {
    const Occupancy rowState = stripState(r, roomSize.y());
    cells_.insert(cells_.end(), columnStates.begin(), columnStates.end());
    if (rowState == Occupancy::kFree) continue;
    Occupancy* const cells = cellsOf(r);
    for (int c = 0; c < columns_; ++c) cells[c] = std::max(cells[c], rowState);
  }
}

void OccupancyMap::markBox(const Box& box, double distanceMetres) {
  const double outer = distanceMetres + kSlackMetres;
  const double inner = distanceMetres - kSlackMetres;
  const int firstRow = floorToInt((box.minZ - outer) * inverseCell_, 0, rows_);
  const int lastRow = floorToInt((box.maxZ + outer) * inverseCell_, -1, rows_ - 1);
  const auto touchedBy = [&](double nearest) -> ColumnRange {
    const double half = halfWidth(outer, nearest);
    return {floorToInt((box.minX - half) * inverseCell_, 0, columns_),
            floorToInt((box.maxX + half) * inverseCell_, -1, columns_ - 1)};
  };
  const auto coveredBy = [&](double farthest) -> ColumnRange {
    const double half = halfWidth(inner, farthest);
    return {floorToInt((box.minX - half) * inverseCell_ + 1.0, 0, columns_),
            floorToInt((box.maxX + half) * inverseCell_ - 1.0, -1, columns_ - 1)};
  };
  // Most rows lie beside the box itself, not beside its rounded corners.
  const ColumnRange touchedBeside = touchedBy(0.0);
  const ColumnRange coveredBeside = coveredBy(0.0);
  for (int r = firstRow; r <= lastRow; ++r) {
    const double low = r * cellMetres_;
    const double high = low + cellMetres_;
    const double nearest = std::max({box.minZ - high, low - box.maxZ, 0.0});
    if (nearest >= outer) continue;
    const ColumnRange touched = nearest > 0.0 ? touchedBy(nearest) : touchedBeside;
    const double farthest = std::max({box.minZ - low, high - box.maxZ, 0.0});
    ColumnRange covered{touched.last + 1, touched.last};
    if (farthest < inner) covered = farthest > 0.0 ? coveredBy(farthest) : coveredBeside;
    const int coveredEnd = std::max(covered.first, covered.last + 1);
    markMixed(r, {touched.first, covered.first - 1});
    std::fill(cellsOf(r) + covered.first, cellsOf(r) + coveredEnd, Occupancy::kBlocked);
    markMixed(r, {coveredEnd, touched.last});
  }
}

}  // namespace stridegraph
