#include "walk/constraint_cost.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stridegraph {
namespace {

constexpr double kOffPaceMetresPerSecond = 0.05;

/// Who is too slow pays the more the farther behind, up to this much.
constexpr double kGradedMetresPerSecond = 0.25;

/// A second against the pace asked for is worth this many metres of detour,
constexpr double kPerSecond = 1.5;
/// getting going from a stand takes no longer than this,
constexpr double kGoingSeconds = 3.0;
/// a metre in an area to avoid so many more,
constexpr double kAvoidPerMetre = 4.0;
/// and a metre outside of all preferred areas so many.
constexpr double kElsewherePerMetre = 1.0;

bool contains(const Rectangle& rectangle, const Vec2& point) {
  return ((point - rectangle.centre).cwiseAbs() - 0.5 * rectangle.size).maxCoeff() <= 0.0;
}

/// By how much a speed is below and above what is asked for and let pass, metres per second; negative where
/// it is not.
struct OffPace {
  double tooSlow = 0.0;
  double tooFast = 0.0;
};

OffPace offPace(const WalkConstraints& constraints, double metresPerSecond) {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  if (constraints.gait) (*constraints.gait == Gait::kRun ? low : high) = kRunMetresPerSecond;
  if (const auto& least = constraints.minSpeedMetresPerSecond)
    low = std::max(low, *least - kOffPaceMetresPerSecond);
  if (const auto& most = constraints.maxSpeedMetresPerSecond)
    high = std::min(high, *most + kOffPaceMetresPerSecond);
  return {low - metresPerSecond, metresPerSecond - high};
}

}  // namespace

bool keepsTo(const WalkConstraints& constraints, double metresPerSecond) {
  const OffPace off = offPace(constraints, metresPerSecond);
  return off.tooSlow <= 0.0 && off.tooFast <= 0.0;
}

double ConstraintCost::perSecondAt(double metresPerSecond) const {
  const OffPace off = offPace(constraints_, metresPerSecond);
  if (off.tooFast > 0.0) return kPerSecond;
  return kPerSecond * std::clamp(off.tooSlow / kGradedMetresPerSecond, 0.0, 1.0);
}

double ConstraintCost::ofPace(const SearchEdge& way) const {
  if (way.sampleCount == 0) return 0.0;
  const double seconds = static_cast<double>(way.sampleCount) / framesPerSecond_;
  return perSecondAt(way.lengthMetres / seconds) * seconds;
}

double ConstraintCost::ofPace(const SearchTables& tables, std::uint32_t arrival) const {
  double price = 0.0;
  tables.arrivals.visitWays(tables.graph, arrival, [&](const ArrivalWay& way) {
    price += way.share() * ofPace(way.edge);
    return true;
  });
  return price;
}

double ConstraintCost::ofMovingStart() const {
  return kGoingSeconds * perSecondAt(0.0);
}

double ConstraintCost::perMetreAt(const Vec2& point) const {
  double more = 0.0;
  bool anyPreferred = false;
  bool preferred = false;
  for (const Area& area : constraints_.areas) {
    const bool inside = contains(area.rectangle, point);
    if (area.kind == AreaKind::kAvoid) {
      if (inside) more = kAvoidPerMetre;
    } else {
      anyPreferred = true;
      preferred = preferred || inside;
    }
  }
  return more + (anyPreferred && !preferred ? kElsewherePerMetre : 0.0);
}

double ConstraintCost::ofPlaces(const FloorTransform& from, std::span<const Eigen::Vector2f> samples) const {
  double cost = 0.0;
  Vec2 before = from.translation;
  for (const Eigen::Vector2f& sample : samples) {
    const Vec2 point = from * Vec2(sample.cast<double>());
    cost += (point - before).norm() * perMetreAt(point);
    before = point;
  }
  return cost;
}

}  // namespace stridegraph
