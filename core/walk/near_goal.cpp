#include "walk/near_goal.h"

#include <fmt/format.h>

#include <algorithm>

#include "walk/walk_cost.h"
#include "walk/walk_measures.h"

namespace stridegraph {
namespace {

/// What a small step counts for beside the way: a captured walk is worth a detour of so much for each step
/// that need not be made up.
constexpr double kStepMetres = 0.45;

/// How direct a walk has to be: so many times the straight way, and so much more, metres; and for each radian
/// of turning on a way of a metre or more, which goes round a curve of about so many metres.
constexpr double kDirectRatio = 1.3;
constexpr double kDirectMetres = 0.3;
constexpr double kMetresPerRadian = 0.35;

/// Where a goal nearer than this cannot be walked to, that it is so near may be the reason.
constexpr double kNoteMetres = 2.0;

/// Who moves by less than this has not taken a step.
constexpr double kLeastStepMetres = 0.2;

bool isLeast(const std::optional<double>& least, double metres) {
  return !least || metres < *least;
}

}  // namespace

std::optional<StepsToGoal> stepsToGoal(const MotionLibrary& library, const StandingBody& body,
                                       const Placement& start, const Placement& goal,
                                       const std::function<bool(std::span<const FloorTransform>)>& isFree) {
  const double metres = (goal.position - start.position).norm();
  if (metres > kNearLegs * body.steps.legMetres) return std::nullopt;
  std::optional<StepPlan> plan = planSteps(start, goal, body.apart, body.steps);
  if (!plan) return std::nullopt;
  SteppedWalkParams params;
  SynthesisedWalk walk = stepWalk(library, body, *plan, params);
  if (!isFree(walk.placements)) {
    params.swayMetres = 0.0;
    walk = stepWalk(library, body, *plan, params);
    if (!isFree(walk.placements)) return std::nullopt;
  }
  const double seconds = static_cast<double>(walk.placements.size()) / library.frames.framesPerSecond;
  const double cost = metres + WalkCost{}.perSecond * seconds + kStepMetres * plan->effort;
  return StepsToGoal{std::move(*plan), std::move(walk), cost};
}

bool isDirect(const StepsToGoal& steps, double walkMetres) {
  const double metres = (steps.plan.goal.translation - steps.plan.start.translation).norm();
  // A curve takes the place of turning on the spot only where the way is long enough for one.
  const double curve = kMetresPerRadian * std::min(1.0, metres) * steps.plan.turnRadians;
  return walkMetres <= kDirectRatio * metres + kDirectMetres + curve;
}

std::optional<double> shortestWalkMetres(const SearchTables& tables) {
  const SearchGraph& graph = tables.graph;
  std::optional<double> least;
  const auto arrivalsOf = [&](std::uint32_t node, const FloorTransform& before, double metresBefore) {
    for (const std::uint32_t id :
         tables.arrivals.near(node, Vec2::Zero(), 2.0 * tables.arrivals.reachMetres())) {
      const Vec2 end = before * tables.arrivals[id].end.translation;
      if (end.norm() < kLeastStepMetres) continue;
      double metres = metresBefore;
      tables.arrivals.visitWays(graph, id, [&](const ArrivalWay& way) {
        metres += way.share() * way.edge.lengthMetres;
        return true;
      });
      if (isLeast(least, metres)) least = metres;
    }
  };
  for (const SearchStart& start : graph.starts()) {
    if (!start.stands || start.edge.to == SearchEdge::kNone) continue;
    if (least && start.edge.lengthMetres >= *least) continue;
    arrivalsOf(start.edge.to, start.edge.end, start.edge.lengthMetres);
  }
  return least;
}

std::string nearGoalNote(const SearchTables& tables, double metres) {
  if (metres > kNoteMetres) return {};
  if (!tables.graph.canStartStanding() || !tables.graph.canEndStanding())
    return fmt::format(
        "; no clip both starts from a stand and comes to one, and the goal is only {:.2f} m away", metres);
  const std::optional<double> shortest = shortestWalkMetres(tables);
  if (!shortest || *shortest <= metres) return {};
  return fmt::format(
      "; the shortest walk of these clips from standing to standing is {:.2f} m, and the goal is {:.2f} m "
      "away",
      *shortest, metres);
}

}  // namespace stridegraph
