#include "walk/planning.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "path/polyline.h"
#include "walk/onward.h"
#include "walk/plan_measures.h"
#include "walk/synthesis.h"

namespace stridegraph {
namespace {

/// How far the search may leave the walk turned from the heading asked for at the goal.
constexpr Angle kGoalTurn = Angle::degrees(10.0);

/// Milliseconds between two calls, by the clock handed in; 0 without one.
class Stopwatch {
 public:
  explicit Stopwatch(const MillisecondClock& clock) : clock_(clock), started_(now()) {}
  double elapsed() const { return now() - started_; }

 private:
  double now() const { return clock_ ? clock_() : 0.0; }
  const MillisecondClock& clock_;
  double started_;
};

PlanStatus statusOf(PathStatus status) {
  switch (status) {
    case PathStatus::kFound:
      return PlanStatus::kArrived;
    case PathStatus::kStartBlocked:
      return PlanStatus::kStartBlocked;
    case PathStatus::kGoalBlocked:
      return PlanStatus::kGoalBlocked;
    case PathStatus::kNoPath:
      break;
  }
  return PlanStatus::kNoPath;
}

PlanStatus statusOf(SearchStatus status) {
  switch (status) {
    case SearchStatus::kArrived:
      return PlanStatus::kArrived;
    case SearchStatus::kNoMotion:
      return PlanStatus::kNoMotion;
    case SearchStatus::kBudgetSpent:
      break;
  }
  return PlanStatus::kBudgetSpent;
}

std::string explainPath(PlanStatus status, double radius) {
  switch (status) {
    case PlanStatus::kStartBlocked:
      return fmt::format("the start is less than {:.2f} m from an obstacle or a wall", radius);
    case PlanStatus::kGoalBlocked:
      return fmt::format("the goal is less than {:.2f} m from an obstacle or a wall", radius);
    case PlanStatus::kNoPath:
      return fmt::format("no way from start to goal is {:.2f} m wide everywhere", 2.0 * radius);
    default:
      return {};
  }
}

/// One plan in the making: each stage fills in its part.
class Planning {
 public:
  Planning(const Prepared& prepared, const Scene& scene, const PlanOptions& options, const PlanTask& task)
      : library_(prepared.library),
        prepared_(prepared),
        scene_(scene),
        options_(options),
        task_(task),
        start_(task.start),
        total_(options.clock) {
    PlanReport& report = plan_.report;
    report.seed = options.seed.value_or(scene.seed);
    report.planner = options.planner;
    report.search = options.search;
    report.radiusMetres = task.floor.radiusMetres();
    report.goalRadiusMetres = options.goalRadiusMetres;
    report.unitsPerMetre = library_.layout.unitsPerMetre;
    report.libraryHash = library_.hash;
  }

  Plan run() {
    if (task_.underWay != nullptr) {
      turn_ = turnOff(prepared_.tables.graph, *task_.underWay, task_.frame);
      if (!turn_) return atItsEnd();
      start_.position = turn_->onward.placement.translation;
    }
    findPath();
    if (plan_.report.status == PlanStatus::kArrived) {
      const MotionPath motion = findMotion();
      if (plan_.report.status == PlanStatus::kArrived) makeWalk(motion);
    }
    plan_.report.totalMilliseconds = total_.elapsed();
    return std::move(plan_);
  }

 private:
  Plan atItsEnd() {
    plan_.report.status = PlanStatus::kNoMotion;
    plan_.report.explanation = "the walk is in its last steps and cannot turn off any more";
    return std::move(plan_);
  }

  void findPath() {
    const Stopwatch watch(options_.clock);
    PathResult found =
        planPath(task_.floor, start_.position, task_.goal.position, options_.planner, plan_.report.seed);
    plan_.report.status = statusOf(found.status);
    plan_.report.explanation = explainPath(plan_.report.status, task_.floor.radiusMetres());
    plan_.report.pathLengthMetres = found.lengthMetres;
    plan_.roadmap = std::move(found.roadmapEdges);
    plan_.path = std::move(found.path);
    field_ = std::move(found.field);
    if (!plan_.path.empty()) plan_.subgoals = subgoals(plan_.path, options_.subgoalSpacingMetres);
    plan_.report.pathMilliseconds = watch.elapsed();
  }

  /// Who is at the goal whenever the walk could end there, in words; nothing where nobody is.
  std::string takenBy() const {
    const double near = Traffic::kMarginMetres - options_.goalRadiusMetres;
    if (!task_.traffic.staysClearOfBodies(task_.goal.position, Traffic::kInTheEnd, near))
      return "another walker stays at the goal";
    const double metres = (task_.goal.position - start_.position).norm() - options_.goalRadiusMetres;
    const double frames = std::max(metres, 0.0) / prepared_.tables.graph.fastestMetresPerFrame();
    const std::uint32_t begun = turn_ ? turn_->onward.frame : 0;
    if (!task_.traffic.isNeverFree(task_.goal.position, near, begun + static_cast<std::uint32_t>(frames)))
      return {};
    return "something that moves is at the goal whenever the walk could end there";
  }

  MotionPath findMotion() {
    const Stopwatch watch(options_.clock);
    if (options_.search == SearchKind::kGuided) plan_.report.explanation = takenBy();
    if (!plan_.report.explanation.empty()) {
      plan_.report.status = PlanStatus::kGoalBlocked;
      return {};
    }
    MotionQuery query{library_, prepared_.tables, task_.floor, start_, task_.goal};
    query.goalRadiusMetres = options_.goalRadiusMetres;
    query.goalTurn = kGoalTurn;
    query.path = plan_.path;
    query.subgoals = plan_.subgoals;
    query.standing = options_.standing;
    query.seed = plan_.report.seed;
    query.accepts = [&](const MotionPath& end, std::uint32_t first) {
      return bent(placementsAlong(library_, end), first).has_value();
    };
    query.improvementExpansions = options_.improvementExpansions;
    query.enoughRatio = options_.enoughRatio;
    query.outOfTime = [&] {
      return options_.budgetMilliseconds > 0.0 && watch.elapsed() > options_.budgetMilliseconds;
    };
    query.field = field_.get();
    query.traffic = &task_.traffic;
    query.constraints = &scene_.constraints;
    query.paces = &prepared_.paces;
    if (turn_) query.onward = turn_->onward;
    MotionResult found = searchMotion(options_.search, query);
    plan_.report.status = statusOf(found.status);
    plan_.report.explanation = std::move(found.explanation);
    plan_.report.expansions = found.expansions;
    if (!found.way.empty()) {
      plan_.path = std::move(found.way);
      plan_.subgoals = subgoals(plan_.path, options_.subgoalSpacingMetres);
    }
    plan_.report.motionMilliseconds = watch.elapsed();
    return std::move(found.path);
  }

  /// The way bent to end at the goal, where that keeps it off everything; it begins at this frame.
  std::optional<BentWay> bent(std::span<const FloorTransform> way, std::uint32_t first) const {
    std::optional<BentWay> bent = bendToGoal(way, task_.goal, task_.floor);
    if (!bent || !task_.traffic.isFree(bent->placements, first)) return std::nullopt;
    const auto end = static_cast<std::uint32_t>(first + bent->placements.size() - 1);
    if (!task_.traffic.staysClearOfBodies(bent->placements.back().translation, end)) return std::nullopt;
    return bent;
  }

  void makeWalk(const MotionPath& found) {
    const Stopwatch watch(options_.clock);
    PlanReport& report = plan_.report;
    plan_.motion = turn_ ? joined(turn_->steps, found, task_.underWay->motion.start) : found;
    SynthesisedWalk made = synthesise(library_, plan_.motion);
    plan_.way = made.placements;
    if (turn_)
      plan_.way = replaced(task_.underWay->way, turn_->onward.frame, placementsAlong(library_, found));
    if (report.search == SearchKind::kGuided) bendEnd();
    moveRoots(made.placements, plan_.way, made.clip);
    if (options_.footCleanup) cleanFeet(made);
    if (turn_) fadeFrom(task_.underWay->walk, task_.frame, made.clip);
    measurePlan({library_, prepared_.tables.graph, prepared_.sources, task_.floor, scene_, task_.goal,
                 options_, plan_.motion, made.clip, task_.traffic},
                report);
    plan_.walk = std::move(made.clip);
    plan_.frameKinds = std::move(made.frameKinds);
    plan_.contacts = std::move(made.contacts);
    report.synthesisMilliseconds = watch.elapsed();
  }

  /// Bends what is still to be gone of the way.
  void bendEnd() {
    const std::uint32_t first = turn_ ? turn_->onward.frame : 0;
    const std::span<const FloorTransform> rest = std::span(plan_.way).subspan(first);
    std::optional<BentWay> bending = bent(rest, first);
    if (!bending) return;
    plan_.report.arrivalWarp = bending->warp;
    if (bending->warp.metres == 0.0) return;
    plan_.unbentWay = plan_.way;
    std::copy(bending->placements.begin(), bending->placements.end(),
              plan_.way.begin() + static_cast<std::ptrdiff_t>(first));
  }

  void cleanFeet(SynthesisedWalk& walk) {
    FootCleanupReport done = prepared_.feet.apply(library_, walk);
    PlanReport& report = plan_.report;
    report.contacts = done.stances;
    report.feetCorrectedMeanMetres = done.meanCorrectionMetres;
    report.feetCorrectedWorstMetres = done.worstCorrectionMetres;
    report.feetLeftAlone = std::move(done.feetLeftAlone);
  }

  const MotionLibrary& library_;
  const Prepared& prepared_;
  const Scene& scene_;
  const PlanOptions& options_;
  const PlanTask& task_;
  Placement start_;              ///< Where the path begins: of a walk under way, where it turns off.
  std::optional<TurnOff> turn_;  ///< Of a walk under way.
  Stopwatch total_;
  std::shared_ptr<const DistanceField> field_;  ///< Of the planner, where it has one.
  Plan plan_;
};

}  // namespace

Plan planWalk(const Prepared& prepared, const Scene& scene, const PlanOptions& options,
              const PlanTask& task) {
  return Planning(prepared, scene, options, task).run();
}

}  // namespace stridegraph
