#include "walk/step_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stridegraph {
namespace {

/// What a metre gone sideways or backwards counts for, in plain steps: half a metre backwards is gone so, and
/// for a whole metre people turn round.
constexpr double kAsideEffort = 2.0;
constexpr double kBehindEffort = 4.0;

/// A stretch of the way along which place and heading change evenly.
struct Stretch {
  Vec2 along = Vec2::Zero();  ///< Room, metres.
  double turnRadians = 0.0;
};

/// Facings at both ends of a way.
struct Facings {
  Heading start;
  Heading goal;
};

double turnBetween(const Heading& from, const Heading& to) {
  return (to - from).angle().radians();
}

bool isSomething(const Stretch& stretch) {
  return stretch.along.norm() > 1e-9 || std::abs(stretch.turnRadians) > 1e-9;
}

/// The body on its way along stretches.
class Stepping {
 public:
  Stepping(const FeetApart& feet, const StepParams& params) : feet_(feet), params_(params) {}

  /// Steps along the stretches that begin with a foot.
  std::optional<StepPlan> along(const FloorTransform& start, const std::vector<Stretch>& stretches,
                                std::size_t firstFoot) {
    StepPlan plan{start, start, {}};
    std::array<FloorTransform, 2> stands = {start, start};
    std::size_t foot = firstFoot;
    for (const Stretch& stretch : stretches) {
      const std::optional<std::vector<double>> shares = sharesOf(stretch, plan.goal.heading, foot);
      if (!shares) return std::nullopt;
      for (const double share : *shares) {
        plan.goal.translation += share * stretch.along;
        plan.goal.heading =
            plan.goal.heading + Heading::fromAngle(Angle::radians(share * stretch.turnRadians));
        plan.steps.push_back({foot, stands[foot], plan.goal});
        stands[foot] = plan.goal;
        foot = 1 - foot;
      }
      plan.turnRadians += std::abs(stretch.turnRadians);
      plan.effort += effortOf(stretch, plan.goal.heading);
    }
    // The other foot comes up.
    if (!plan.steps.empty()) plan.steps.push_back({foot, stands[foot], plan.goal});
    if (plan.steps.size() > params_.mostSteps) return std::nullopt;
    plan.effort += static_cast<double>(plan.steps.size());
    return plan;
  }

 private:
  /// Shares of a stretch for its steps: as few as the limits allow, and each as large a share of what its
  /// foot may do as any other.
  std::optional<std::vector<double>> sharesOf(const Stretch& stretch, const Heading& facing,
                                              std::size_t foot) const {
    std::vector<double> shares;
    double sum = 0.0;
    double turned = 0.0;
    while (sum < 1.0) {
      if (shares.size() > params_.mostSteps) return std::nullopt;
      const Heading now = facing + Heading::fromAngle(Angle::radians(turned));
      const double most = mostOf(stretch, now, foot);
      shares.push_back(most);
      sum += most;
      turned += std::min(most, 1.0) * stretch.turnRadians;
      foot = 1 - foot;
    }
    for (double& share : shares) share /= sum;
    return shares;
  }

  /// The largest share of a stretch that a foot can go in a step of a body that faces there.
  double mostOf(const Stretch& stretch, const Heading& facing, std::size_t foot) const {
    const Vec2 own = Heading{-facing.sin, facing.cos}.rotate(stretch.along);
    const double side = feet_.leftMetres[foot] >= feet_.leftMetres[1 - foot] ? 1.0 : -1.0;
    const double outward = side * own.x();
    const double outwardTurn = side * stretch.turnRadians;
    const double leg = params_.legMetres;
    double most = std::numeric_limits<double>::infinity();
    const auto limit = [&most](double needed, double allowed) {
      if (needed > 1e-9) most = std::min(most, allowed / needed);
    };
    limit(own.y(), params_.ahead * leg);
    limit(-own.y(), params_.behind * leg);
    limit(outward, params_.aside * leg);
    limit(-outward, params_.narrowing * feet_.metres());
    limit(outwardTurn, params_.outward.radians());
    limit(-outwardTurn, params_.inward.radians());
    return most;
  }

  static double effortOf(const Stretch& stretch, const Heading& facingAtEnd) {
    const Heading middle = facingAtEnd + Heading::fromAngle(Angle::radians(-0.5 * stretch.turnRadians));
    const Vec2 own = Heading{-middle.sin, middle.cos}.rotate(stretch.along);
    return kAsideEffort * std::abs(own.x()) + kBehindEffort * std::max(0.0, -own.y());
  }

  const FeetApart& feet_;
  const StepParams& params_;
};

/// Facings worth trying: those asked for, along the way, and that of the other end.
std::vector<Facings> facingsOf(const Placement& start, const Placement& goal, const Heading& along) {
  const auto asked = [](const Placement& placement, const Heading& otherwise) {
    return placement.heading ? Heading::fromAngle(*placement.heading) : otherwise;
  };
  const Heading first = asked(start, asked(goal, along));
  std::vector<Facings> facings = {{first, asked(goal, first)}};
  if (!start.heading && goal.heading) facings.push_back({along, facings[0].goal});
  if (start.heading && !goal.heading) facings.push_back({first, along});
  return facings;
}

}  // namespace

double FeetApart::metres() const {
  return std::abs(leftMetres[0] - leftMetres[1]);
}

std::optional<StepPlan> planSteps(const Placement& start, const Placement& goal, const FeetApart& feet,
                                  const StepParams& params) {
  const Vec2 way = goal.position - start.position;
  const bool stays = way.norm() < kThereMetres;
  const Heading ahead = stays ? Heading{} : Heading::alongDirection(way);
  Stepping stepping(feet, params);
  std::optional<StepPlan> best;
  const auto consider = [&](const Facings& facings, const std::vector<Stretch>& stretches) {
    for (const std::size_t foot : {0U, 1U}) {
      std::optional<StepPlan> plan = stepping.along({start.position, facings.start}, stretches, foot);
      if (plan && (!best || plan->effort < best->effort)) best = std::move(plan);
    }
  };
  for (const Facings& facings : facingsOf(start, goal, stays ? Heading{} : ahead)) {
    const double turn = turnBetween(facings.start, facings.goal);
    if (stays && std::abs(turn) < kThereTurn.radians()) {
      return StepPlan{{start.position, facings.start}, {start.position, facings.start}, {}};
    }
    consider(facings, {{way, turn}});
    if (stays) continue;
    std::vector<Stretch> turnFirst = {{Vec2::Zero(), turnBetween(facings.start, ahead)},
                                      {way, 0.0},
                                      {Vec2::Zero(), turnBetween(ahead, facings.goal)}};
    std::erase_if(turnFirst, [](const Stretch& stretch) { return !isSomething(stretch); });
    consider(facings, turnFirst);
  }
  return best;
}

}  // namespace stridegraph
