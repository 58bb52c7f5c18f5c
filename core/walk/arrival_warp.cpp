#include "walk/arrival_warp.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "walk/bent_step.h"

namespace stridegraph {
namespace {

/// Lengths of the bent end that are tried, metres; the shortest only where all longer ones touch something.
constexpr std::array<double, 6> kLengthsMetres = {3.0, 4.0, 5.5, 8.0, 2.0, 1.2};

/// Share of the bent end over which the bending grows from nothing to its full weight.
constexpr double kGrowingShare = 0.35;

constexpr int kMostSteps = 6;  ///< Of Newton's method; three are usual.

/// A first step of Newton's method that goes this much beyond the limits will not come back.
constexpr double kHopeless = 1.5;

/// How a step of the root is changed.
struct StepChange {
  double stretch = 0.0;
  double turnPerMetre = 0.0;  ///< rad
};

/// A step of the way's end that may change.
struct BentStep {
  FloorTransform step;  ///< From the frame before, as it was.
  double metres = 0.0;
  double weight = 0.0;  ///< 0..1, grows smoothly with the way gone since the bending began.
  StepChange change;
};

/// The root's way over the floor, its end to be bent.
class Bending {
 public:
  Bending(std::span<const FloorTransform> way, const Placement& goal, const ArrivalWarpParams& params)
      : way_(way), goal_(goal), params_(params) {}

  bool isExact(const FloorTransform& end) const {
    const Eigen::Vector3d rest = restOf(end);
    return rest.head<2>().norm() <= params_.exactMetres && std::abs(rest.z()) <= params_.exactTurn.radians();
  }

  /// The way with its last `metres` bent; nothing when that takes more than the limits allow.
  std::optional<std::vector<FloorTransform>> bend(double metres) {
    takeSteps(metres);
    std::vector<FloorTransform> end(way_.end() - static_cast<std::ptrdiff_t>(steps_.size() + 1), way_.end());
    for (int i = 0; i < kMostSteps && !isExact(end.back()); ++i) {
      improve(end);
      if (exceeds(kHopeless)) return std::nullopt;
      layOut(end);
    }
    if (!isExact(end.back()) || exceeds(1.0)) return std::nullopt;
    std::vector<FloorTransform> bent(way_.begin(), way_.end());
    std::copy(end.begin(), end.end(), bent.end() - static_cast<std::ptrdiff_t>(end.size()));
    return bent;
  }

  /// The largest changes of either kind.
  StepChange largest() const {
    StepChange most;
    for (const BentStep& bent : steps_) {
      most.stretch = std::max(most.stretch, std::abs(bent.change.stretch));
      most.turnPerMetre = std::max(most.turnPerMetre, std::abs(bent.change.turnPerMetre));
    }
    return most;
  }

 private:
  /// What is missing at the way's end: x, z, and the turn (0 where the goal has no heading).
  Eigen::Vector3d restOf(const FloorTransform& end) const {
    const Vec2 missing = goal_.position - end.translation;
    double turn = 0.0;
    if (goal_.heading) turn = (Heading::fromAngle(*goal_.heading) - end.heading).angle().radians();
    return {missing.x(), missing.y(), turn};
  }

  /// Whether a change is more than so many times its limit.
  bool exceeds(double times) const {
    const StepChange most = largest();
    return most.stretch > times * params_.stretch ||
           most.turnPerMetre > times * params_.turnPerMetre.radians();
  }

  /// The last steps, `metres` long together or all there are.
  void takeSteps(double metres) {
    std::size_t first = way_.size() - 1;
    double whole = 0.0;
    while (first > 0 && whole < metres) {
      --first;
      whole += (way_[first + 1].translation - way_[first].translation).norm();
    }
    steps_.assign(way_.size() - 1 - first, {});
    const double begin = std::max(0.0, whole - metres);
    const double growing = kGrowingShare * (whole - begin);
    double gone = 0.0;
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      const FloorTransform& before = way_[first + k];
      steps_[k].step = before.inverse() * way_[first + k + 1];
      steps_[k].metres = (way_[first + k + 1].translation - before.translation).norm();
      gone += steps_[k].metres;
      if (gone <= begin || growing <= 0.0) continue;
      const double share = std::min(1.0, (gone - begin) / growing);
      steps_[k].weight = share * share * (3.0 - 2.0 * share);
    }
  }

  /// What a step's stretch and turn do to the rest, to first order.
  struct Effects {
    Eigen::Vector3d ofStretch = Eigen::Vector3d::Zero();
    Eigen::Vector3d ofTurn = Eigen::Vector3d::Zero();
  };
  Effects effectsOf(const std::vector<FloorTransform>& end, std::size_t k) const {
    if (steps_[k].weight == 0.0 || steps_[k].metres == 0.0) return {};
    const Vec2 along = (end[k + 1].translation - end[k].translation) / steps_[k].metres;
    const Vec2 ahead = end.back().translation - end[k].translation;
    return {{along.x(), along.y(), 0.0}, {ahead.y(), -ahead.x(), goal_.heading ? 1.0 : 0.0}};
  }

  /// One step of Newton's method: the changes of least norm that make up for what is missing, to first order.
  void improve(const std::vector<FloorTransform>& end) {
    const double stretchUnit = params_.stretch * params_.stretch;
    const double turnUnit = params_.turnPerMetre.radians() * params_.turnPerMetre.radians();
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      const Effects effects = effectsOf(end, k);
      const double weight = steps_[k].weight * steps_[k].metres;
      normal += weight * (stretchUnit * effects.ofStretch * effects.ofStretch.transpose() +
                          turnUnit * effects.ofTurn * effects.ofTurn.transpose());
    }
    if (!goal_.heading) normal(2, 2) = 1.0;
    const Eigen::Vector3d shares = normal.fullPivLu().solve(restOf(end.back()));
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      const Effects effects = effectsOf(end, k);
      steps_[k].change.stretch += steps_[k].weight * stretchUnit * effects.ofStretch.dot(shares);
      steps_[k].change.turnPerMetre += steps_[k].weight * turnUnit * effects.ofTurn.dot(shares);
    }
  }

  /// Lays the end out as changed, from its first frame on.
  void layOut(std::vector<FloorTransform>& end) const {
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      const BentStep& bent = steps_[k];
      FloorTransform step = bent.step;
      step.translation *= 1.0 + bent.change.stretch;
      end[k + 1] = end[k] * bentStep(step, Angle::radians(bent.change.turnPerMetre));
    }
  }

  std::span<const FloorTransform> way_;
  const Placement& goal_;
  const ArrivalWarpParams& params_;
  std::vector<BentStep> steps_;
};

bool isFree(const FloorPlan& plan, const std::vector<FloorTransform>& way) {
  return std::all_of(way.begin(), way.end(),
                     [&](const FloorTransform& placement) { return plan.isFree(placement.translation); });
}

}  // namespace

std::optional<BentWay> bendToGoal(std::span<const FloorTransform> way, const Placement& goal,
                                  const FloorPlan& plan, const ArrivalWarpParams& params) {
  Bending bending(way, goal, params);
  if (bending.isExact(way.back())) return BentWay{{way.begin(), way.end()}, {}};
  for (const double metres : kLengthsMetres) {
    std::optional<std::vector<FloorTransform>> bent = bending.bend(metres);
    if (!bent || !isFree(plan, *bent)) continue;
    const StepChange largest = bending.largest();
    return BentWay{std::move(*bent), {metres, largest.stretch, Angle::radians(largest.turnPerMetre)}};
  }
  return std::nullopt;
}

void moveRoots(std::span<const FloorTransform> from, std::span<const FloorTransform> to, Clip& walk) {
  const auto isSame = [](const FloorTransform& a, const FloorTransform& b) {
    return a.translation == b.translation && a.heading.sin == b.heading.sin && a.heading.cos == b.heading.cos;
  };
  for (std::size_t f = 0; f < walk.frameCount(); ++f) {
    if (isSame(from[f], to[f])) continue;
    const Heading turn = to[f].heading - from[f].heading;
    Vec3& root = walk.rootPositions[f];
    root = {to[f].translation.x(), root.y(), to[f].translation.y()};
    Quat& rotation = walk.rotationsOf(f)[0];
    rotation = (turn.rotation() * rotation).normalized();
  }
}

}  // namespace stridegraph
