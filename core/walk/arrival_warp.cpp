#include "walk/arrival_warp.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace stridegraph {
namespace {

/// Lengths of the bent end that are tried, metres.
constexpr std::array<double, 7> kLengthsMetres = {3.0, 4.0, 5.5, 8.0, 12.0, 20.0, 40.0};

/// Share of the bent end over which the bending grows from nothing to its full weight.
constexpr double kGrowingShare = 0.35;

constexpr int kMostSteps = 12;  ///< Of Newton's method; three are usual.

/// How a step of the root is changed.
struct StepChange {
  double stretch = 0.0;
  double turnPerMetre = 0.0;  ///< rad
};

/// The root's way over the floor, its end to be bent.
class Bending {
 public:
  Bending(std::span<const FloorTransform> way, const Placement& goal, const ArrivalWarpParams& params)
      : goal_(goal), params_(params), original_(way.begin(), way.end()) {}

  bool isExact(const std::vector<FloorTransform>& way) const {
    const Eigen::Vector3d rest = restOf(way);
    return rest.head<2>().norm() <= params_.exactMetres && std::abs(rest.z()) <= params_.exactTurn.radians();
  }

  /// The way with its last `metres` bent; nothing when that takes more than the limits allow.
  std::optional<std::vector<FloorTransform>> bend(double metres) {
    weigh(metres);
    changes_.assign(lengths_.size(), {});
    std::vector<FloorTransform> way = original_;
    for (int i = 0; i < kMostSteps && !isExact(way); ++i) {
      improve(way);
      way = changedWay();
    }
    if (!isExact(way) || largest().stretch > params_.stretch ||
        largest().turnPerMetre > params_.turnPerMetre.radians())
      return std::nullopt;
    return way;
  }

  /// The largest changes of either kind.
  StepChange largest() const {
    StepChange most;
    for (const StepChange& change : changes_) {
      most.stretch = std::max(most.stretch, std::abs(change.stretch));
      most.turnPerMetre = std::max(most.turnPerMetre, std::abs(change.turnPerMetre));
    }
    return most;
  }

 private:
  /// What is missing at the way's end: x, z, and the turn (0 where the goal has no heading).
  Eigen::Vector3d restOf(const std::vector<FloorTransform>& way) const {
    const Vec2 missing = goal_.position - way.back().translation;
    double turn = 0.0;
    if (goal_.heading) {
      turn = (Heading::fromAngle(*goal_.heading) - way.back().heading).angle().radians();
    }
    return {missing.x(), missing.y(), turn};
  }

  /// Step lengths, and weights that grow smoothly with the way gone since the bending began.
  void weigh(double metres) {
    const std::size_t steps = original_.size() - 1;
    lengths_.assign(steps, 0.0);
    weights_.assign(steps, 0.0);
    double whole = 0.0;
    for (std::size_t k = steps; k-- > 0;) {
      lengths_[k] = (original_[k + 1].translation - original_[k].translation).norm();
      whole += lengths_[k];
    }
    const double begin = std::max(0.0, whole - metres);
    const double growing = kGrowingShare * (whole - begin);
    double gone = 0.0;
    for (std::size_t k = 0; k < steps; ++k) {
      gone += lengths_[k];
      if (gone <= begin || growing <= 0.0) continue;
      const double share = std::min(1.0, (gone - begin) / growing);
      weights_[k] = share * share * (3.0 - 2.0 * share);
    }
  }

  /// One step of Newton's method: the changes of least norm that make up for what is missing, to first order.
  void improve(const std::vector<FloorTransform>& way) {
    using Row = Eigen::Vector3d;
    const double stretchUnit = params_.stretch * params_.stretch;
    const double turnUnit = params_.turnPerMetre.radians() * params_.turnPerMetre.radians();
    std::vector<Row> byStretch(lengths_.size(), Row::Zero());
    std::vector<Row> byTurn(lengths_.size(), Row::Zero());
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    for (std::size_t k = 0; k < lengths_.size(); ++k) {
      if (weights_[k] == 0.0 || lengths_[k] == 0.0) continue;
      const Vec2 along = (way[k + 1].translation - way[k].translation) / lengths_[k];
      const Vec2 ahead = way.back().translation - way[k].translation;
      byStretch[k] = {along.x(), along.y(), 0.0};
      byTurn[k] = {ahead.y(), -ahead.x(), goal_.heading ? 1.0 : 0.0};
      const double weight = weights_[k] * lengths_[k];
      normal += weight * (stretchUnit * byStretch[k] * byStretch[k].transpose() +
                          turnUnit * byTurn[k] * byTurn[k].transpose());
    }
    if (!goal_.heading) normal(2, 2) = 1.0;
    const Row shares = normal.fullPivLu().solve(restOf(way));
    for (std::size_t k = 0; k < lengths_.size(); ++k) {
      changes_[k].stretch += weights_[k] * stretchUnit * byStretch[k].dot(shares);
      changes_[k].turnPerMetre += weights_[k] * turnUnit * byTurn[k].dot(shares);
    }
  }

  std::vector<FloorTransform> changedWay() const {
    std::vector<FloorTransform> way = {original_.front()};
    for (std::size_t k = 0; k < lengths_.size(); ++k) {
      FloorTransform step = original_[k].inverse() * original_[k + 1];
      step.translation *= 1.0 + changes_[k].stretch;
      // The turn comes first, so that it bends this step too.
      const Heading turn = Heading::fromAngle(Angle::radians(changes_[k].turnPerMetre * lengths_[k]));
      way.push_back(way.back() * FloorTransform{Vec2::Zero(), turn} * step);
    }
    return way;
  }

  const Placement& goal_;
  const ArrivalWarpParams& params_;
  std::vector<FloorTransform> original_;
  std::vector<double> lengths_, weights_;  ///< For each step.
  std::vector<StepChange> changes_;
};

bool isFree(const FloorPlan& plan, const std::vector<FloorTransform>& way) {
  return std::all_of(way.begin(), way.end(),
                     [&](const FloorTransform& placement) { return plan.isFree(placement.translation); });
}

}  // namespace

std::optional<BentWay> bendToGoal(std::span<const FloorTransform> way, const Placement& goal,
                                  const FloorPlan& plan, const ArrivalWarpParams& params) {
  Bending bending(way, goal, params);
  std::vector<FloorTransform> unbent(way.begin(), way.end());
  if (bending.isExact(unbent)) return BentWay{std::move(unbent), {}};
  for (const double metres : kLengthsMetres) {
    std::optional<std::vector<FloorTransform>> bent = bending.bend(metres);
    if (!bent || !isFree(plan, *bent)) continue;
    const StepChange largest = bending.largest();
    return BentWay{std::move(*bent), {metres, largest.stretch, Angle::radians(largest.turnPerMetre)}};
  }
  return std::nullopt;
}

void moveRoots(std::span<const FloorTransform> from, std::span<const FloorTransform> to, Clip& walk) {
  for (std::size_t f = 0; f < walk.frameCount(); ++f) {
    const Heading turn = to[f].heading - from[f].heading;
    Vec3& root = walk.rootPositions[f];
    root = {to[f].translation.x(), root.y(), to[f].translation.y()};
    Quat& rotation = walk.rotationsOf(f)[0];
    rotation = (turn.rotation() * rotation).normalized();
  }
}

}  // namespace stridegraph
