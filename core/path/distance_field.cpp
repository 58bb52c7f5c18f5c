#include "path/distance_field.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

namespace stridegraph {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFinestCellMetres = 0.1;
constexpr double kCoarsestCellMetres = 0.25;
constexpr double kUsualCells = 160'000.0;
constexpr double kMostWeight = 100.0;
constexpr double kMostCells = 4'000'000.0;
constexpr float kLeastStep = 0.7F;  ///< Share of a cell: a little less than 1 / sqrt(2).
/// Of cells that the front has not reached yet; walls are infinite.
constexpr float kUnreached = std::numeric_limits<float>::max();
constexpr float kWall = std::numeric_limits<float>::infinity();

double chooseCellMetres(const FloorPlan& plan, double asked) {
  const double area = plan.widthMetres() * plan.depthMetres();
  const double usual = std::clamp(std::sqrt(area / kUsualCells), kFinestCellMetres, kCoarsestCellMetres);
  const double wanted = asked > 0.0 ? asked : std::min(usual, plan.radiusMetres());
  return std::max(wanted, std::sqrt(area / kMostCells));
}

/// Solves (u - a)^2 + (u - b)^2 = h^2 for the larger u; where only one neighbour is upwind, low + h is what
/// a difference of h gives, without a branch.
float eikonalUpdate(float a, float b, float h) {
  const float low = std::min(a, b);
  const float difference = std::min(std::max(a, b) - low, h);
  return low + 0.5F * (difference + std::sqrt(2.0F * h * h - difference * difference));
}

}  // namespace

/// The front: cells in rings of like value, each emptied in the order in which it was filled (the untidy
/// queue of Yatziv, Bartesaghi and Sapiro 2006). A cell may come up to half a cell's width too early; what
/// that adds to the distances is less than first-order marching does itself.
struct DistanceField::Marching {
  std::vector<float> widths;  ///< Of each cell in weighted metres; empty where all are alike.
  std::vector<std::vector<std::uint32_t>> rings;
  float inverseWidth = 1.0F;
  std::size_t current = 0;  ///< Ring at hand, counted from value 0.
  std::size_t waiting = 0;  ///< Cells in all rings.

  /// The front spans `spanMetres` of values at most.
  void begin(double cellMetres, double spanMetres) {
    inverseWidth = static_cast<float>(2.0 / cellMetres);
    // A power of two, so that no push has to divide.
    rings.resize(std::bit_ceil(static_cast<std::size_t>(spanMetres * double{inverseWidth}) + 3));
  }
  std::vector<std::uint32_t>& ringAt(std::size_t ring) { return rings[ring & (rings.size() - 1)]; }
  void push(float value, std::size_t cell) {
    const auto ring = static_cast<std::size_t>(static_cast<std::uint32_t>(value * inverseWidth));
    ringAt(std::max(current, ring)).push_back(static_cast<std::uint32_t>(cell));
    ++waiting;
  }
};

DistanceField::DistanceField(const FloorPlan& plan, const Vec2& goal, const Params& params)
    : goal_(goal),
      cellMetres_(chooseCellMetres(plan, params.cellMetres)),
      inverseCell_(1.0 / cellMetres_),
      columns_(static_cast<std::size_t>(std::ceil(plan.widthMetres() * inverseCell_))),
      rows_(static_cast<std::size_t>(std::ceil(plan.depthMetres() * inverseCell_))),
      stride_(columns_ + 2),
      values_(stride_ * (rows_ + 2), kWall) {
  Marching marching;
  openFreeCells(plan);
  openCellsAlong(params.openPath);
  if (params.weight) weighCells(params.weight, marching);
  if (plan.isFree(goal)) seedAroundGoal(plan, params.exactRadiusMetres, marching);
  march(marching);
  for (float& value : values_) value = value == kUnreached ? kWall : value;
}

std::size_t DistanceField::cellUnder(const Vec2& point) const {
  const auto clampedCell = [&](double metres, std::size_t count) {
    const double index = std::clamp(metres * inverseCell_, 0.0, static_cast<double>(count) - 0.5);
    return static_cast<std::size_t>(index) + 1;
  };
  return indexOf(clampedCell(point.x(), columns_), clampedCell(point.y(), rows_));
}

void DistanceField::openFreeCells(const FloorPlan& plan) {
  std::vector<std::uint8_t> blocked(columns_);
  for (std::size_t r = 1; r <= rows_; ++r) {
    plan.findBlocked(centreOf(1, r).y(), cellMetres_, blocked);
    float* const row = values_.data() + indexOf(1, r);
    for (std::size_t c = 0; c < columns_; ++c) row[c] = blocked[c] != 0 ? kWall : kUnreached;
  }
}

void DistanceField::openCellsAlong(const std::vector<Vec2>& path) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec2 along = path[i] - path[i - 1];
    const int steps = 1 + static_cast<int>(4.0 * along.norm() * inverseCell_);
    std::size_t before = cellUnder(path[i - 1]);
    values_[before] = kUnreached;
    for (int step = 1; step <= steps; ++step) {
      const std::size_t cell = cellUnder(path[i - 1] + (static_cast<double>(step) / steps) * along);
      values_[cell] = kUnreached;
      // The front moves along rows and columns only: a diagonal step opens the cell between as well.
      values_[indexOf(cell % stride_, before / stride_)] = kUnreached;
      before = cell;
    }
  }
}

void DistanceField::weighCells(const std::function<double(const Vec2&)>& weight, Marching& marching) const {
  marching.widths.resize(values_.size());
  for (std::size_t r = 1; r <= rows_; ++r) {
    for (std::size_t c = 1; c <= columns_; ++c) {
      const double width = std::clamp(weight(centreOf(c, r)), 1.0, kMostWeight) * cellMetres_;
      marching.widths[indexOf(c, r)] = static_cast<float>(width);
    }
  }
}

void DistanceField::seedAroundGoal(const FloorPlan& plan, double exactRadiusMetres, Marching& marching) {
  const std::size_t goalCell = cellUnder(goal_);
  const double radius = std::max(exactRadiusMetres, 2.0 * cellMetres_);
  const double widest = marching.widths.empty()
                            ? cellMetres_
                            : double{*std::max_element(marching.widths.begin(), marching.widths.end())};
  marching.begin(cellMetres_, radius + 2.0 * widest);
  const auto reach = static_cast<std::ptrdiff_t>(std::ceil(radius * inverseCell_));
  const auto column = static_cast<std::ptrdiff_t>(goalCell % stride_);
  const auto row = static_cast<std::ptrdiff_t>(goalCell / stride_);
  const auto clampTo = [](std::ptrdiff_t value, std::size_t high) {
    return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(value, 1, static_cast<std::ptrdiff_t>(high)));
  };
  const auto seed = [&](std::size_t cell, double metres) {
    values_[cell] = static_cast<float>(metres);
    marching.push(values_[cell], cell);
  };
  for (std::size_t r = clampTo(row - reach, rows_); r <= clampTo(row + reach, rows_); ++r) {
    for (std::size_t c = clampTo(column - reach, columns_); c <= clampTo(column + reach, columns_); ++c) {
      const std::size_t cell = indexOf(c, r);
      const Vec2 centre = centreOf(c, r);
      const double metres = (centre - goal_).norm();
      const bool known = cell == goalCell || (metres <= radius && plan.isFree(centre, goal_));
      if (known && values_[cell] != kWall) seed(cell, metres);
    }
  }
}

void DistanceField::march(Marching& marching) {
  constexpr std::size_t kBack = static_cast<std::size_t>(-1);
  const auto cellMetres = static_cast<float>(cellMetres_);
  float* const values = values_.data();
  for (; marching.waiting > 0; ++marching.current) {
    std::vector<std::uint32_t>& ring = marching.ringAt(marching.current);
    // Cells of like value are added to the ring while it is being emptied.
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::size_t cell = ring[i];
      const float here = values[cell];
      // Values that lie lower than a step across two like neighbours gain next to nothing: not looking at
      // them again adds a few millionths to the distances.
      const float lowest = here + kLeastStep * cellMetres;
      const auto look = [&](std::size_t ahead, std::size_t aside) {
        const std::size_t next = cell + ahead;
        if (values[next] <= lowest || values[next] == kWall) return;
        const float width = marching.widths.empty() ? cellMetres : marching.widths[next];
        const float updated = eikonalUpdate(std::min(here, values[next + ahead]),
                                            std::min(values[next - aside], values[next + aside]), width);
        if (updated >= values[next]) return;
        values[next] = updated;
        marching.push(updated, next);
      };
      look(kBack, stride_);
      look(1, stride_);
      look(kBack * stride_, 1);
      look(stride_, 1);
    }
    marching.waiting -= ring.size();
    ring.clear();
  }
}

double DistanceField::nearbyMetres(const Vec2& point, int reach) const {
  const double column = std::floor(point.x() * inverseCell_ + 0.5);
  const double row = std::floor(point.y() * inverseCell_ + 0.5);
  double best = kInfinity;
  for (int dr = 1 - reach; dr <= reach; ++dr) {
    for (int dc = 1 - reach; dc <= reach; ++dc) {
      const double c = column + dc;
      const double r = row + dr;
      if (c < 1.0 || r < 1.0 || c > static_cast<double>(columns_) || r > static_cast<double>(rows_)) continue;
      const auto cellColumn = static_cast<std::size_t>(c);
      const auto cellRow = static_cast<std::size_t>(r);
      const double value = double{values_[indexOf(cellColumn, cellRow)]};
      if (value < best) best = std::min(best, value + (centreOf(cellColumn, cellRow) - point).norm());
    }
  }
  return best;
}

double DistanceField::metresToGoal(const Vec2& point) const {
  // Between the middles of padded cells (c, r) and (c + 1, r + 1).
  const double x = point.x() * inverseCell_ + 0.5;
  const double z = point.y() * inverseCell_ + 0.5;
  if (!(x >= 0.0 && z >= 0.0 && x < static_cast<double>(columns_ + 1) &&
        z < static_cast<double>(rows_ + 1))) {
    return kInfinity;
  }
  const auto c = static_cast<std::size_t>(x);
  const auto r = static_cast<std::size_t>(z);
  const double alongX = x - static_cast<double>(c);
  const double alongZ = z - static_cast<double>(r);
  const float* const low = values_.data() + indexOf(c, r);
  const float* const high = low + stride_;
  const double value = (1.0 - alongZ) * ((1.0 - alongX) * double{low[0]} + alongX * double{low[1]}) +
                       alongZ * ((1.0 - alongX) * double{high[0]} + alongX * double{high[1]});
  if (std::isfinite(value)) {
    // Bilinear values are blunt at the cone's tip; nothing fits between the goal and its own cells.
    return value < 1.5 * cellMetres_ ? (point - goal_).norm() : value;
  }
  const double near = nearbyMetres(point, 1);
  return std::isfinite(near) ? near : nearbyMetres(point, 2);
}

DistanceField::Sample DistanceField::at(const Vec2& point) const {
  const double x = point.x() * inverseCell_ + 0.5;
  const double z = point.y() * inverseCell_ + 0.5;
  if (!(x >= 0.0 && z >= 0.0 && x < static_cast<double>(columns_ + 1) &&
        z < static_cast<double>(rows_ + 1))) {
    return {kInfinity, Vec2::Zero()};
  }
  const auto c = static_cast<std::size_t>(x);
  const auto r = static_cast<std::size_t>(z);
  const double alongX = x - static_cast<double>(c);
  const double alongZ = z - static_cast<double>(r);
  const float* const low = values_.data() + indexOf(c, r);
  const float* const high = low + stride_;
  const double lowMetres = double{low[0]} + alongX * (double{low[1]} - double{low[0]});
  const double highMetres = double{high[0]} + alongX * (double{high[1]} - double{high[0]});
  const double metres = lowMetres + alongZ * (highMetres - lowMetres);
  if (!std::isfinite(metres)) return {metresToGoal(point), directionToGoal(point)};
  if (metres < 1.5 * cellMetres_) {
    const Vec2 toGoal = goal_ - point;
    return {toGoal.norm(), toGoal.norm() > 1e-9 ? Vec2(toGoal.normalized()) : Vec2::Zero()};
  }
  const Vec2 fall(
      (1.0 - alongZ) * (double{low[0]} - double{low[1]}) + alongZ * (double{high[0]} - double{high[1]}),
      lowMetres - highMetres);
  const double norm = fall.norm();
  return {metres, norm > 1e-9 ? Vec2(fall / norm) : Vec2::Zero()};
}

/// The cell of the least value among those at most so many rows and columns away; itself when none is less.
std::size_t DistanceField::lowestAround(std::size_t cell, std::size_t reach) const {
  const std::size_t column = cell % stride_;
  const std::size_t row = cell / stride_;
  std::size_t lowest = cell;
  for (std::size_t r = row - std::min(row, reach); r <= std::min(row + reach, rows_ + 1); ++r)
    for (std::size_t c = column - std::min(column, reach); c <= std::min(column + reach, columns_ + 1); ++c)
      if (values_[indexOf(c, r)] < values_[lowest]) lowest = indexOf(c, r);
  return lowest;
}

std::vector<Vec2> DistanceField::cellsToGoal(const Vec2& point) const {
  std::vector<Vec2> way;
  std::size_t cell = cellUnder(point);
  if (!std::isfinite(values_[cell])) cell = lowestAround(cell, 2);
  while (std::isfinite(values_[cell])) {
    way.push_back(centreOf(cell % stride_, cell / stride_));
    const std::size_t next = lowestAround(cell, 1);
    if (next == cell) break;
    cell = next;
  }
  return way;
}

Vec2 DistanceField::directionToGoal(const Vec2& point) const {
  const double step = 0.5 * cellMetres_;
  const double here = metresToGoal(point);
  if (!std::isfinite(here)) return Vec2::Zero();
  const auto slope = [&](const Vec2& offset) {
    const double ahead = metresToGoal(point + offset);
    const double behind = metresToGoal(point - offset);
    if (std::isfinite(ahead) && std::isfinite(behind)) return behind - ahead;
    if (std::isfinite(ahead)) return here - ahead;
    return std::isfinite(behind) ? behind - here : 0.0;
  };
  const Vec2 fall(slope({step, 0.0}), slope({0.0, step}));
  const double norm = fall.norm();
  return norm > 1e-9 ? Vec2(fall / norm) : Vec2::Zero();
}

}  // namespace stridegraph
