#include "walk/constraint_cost.h"

#include <algorithm>
#include <cmath>

namespace stridegraph {
namespace {

constexpr double kOffPaceMetresPerSecond = 0.05;

/// A second against the pace asked for is worth this many metres of detour,
constexpr double kPerSecond = 1.5;
/// a metre in an area to avoid so many more,
constexpr double kAvoidPerMetre = 4.0;
/// and a metre outside of all preferred areas so many.
constexpr double kElsewherePerMetre = 1.0;

bool contains(const Rectangle& rectangle, const Vec2& point) {
  return ((point - rectangle.centre).cwiseAbs() - 0.5 * rectangle.size).maxCoeff() <= 0.0;
}

}  // namespace

bool keepsTo(const WalkConstraints& constraints, double metresPerSecond) {
  if (constraints.gait && (metresPerSecond > kRunMetresPerSecond) != (*constraints.gait == Gait::kRun))
    return false;
  if (constraints.minSpeedMetresPerSecond &&
      metresPerSecond < *constraints.minSpeedMetresPerSecond - kOffPaceMetresPerSecond)
    return false;
  return !constraints.maxSpeedMetresPerSecond ||
         metresPerSecond <= *constraints.maxSpeedMetresPerSecond + kOffPaceMetresPerSecond;
}

double ConstraintCost::ofPace(const SearchEdge& way) const {
  if (way.sampleCount == 0) return 0.0;
  const double seconds = static_cast<double>(way.sampleCount) / framesPerSecond_;
  return keepsTo(constraints_, way.lengthMetres / seconds) ? 0.0 : kPerSecond * seconds;
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
