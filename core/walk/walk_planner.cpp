#include <fmt/format.h>

#include <utility>

#include "path/polyline.h"
#include "scene/scene_json.h"
#include "walk/plan.h"
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

Result<void> checkRange(std::string_view name, double value, double low, double high) {
  if (value >= low && value <= high) return {};
  return fail(ErrorCode::kInvalidArgument,
              fmt::format("{}: found {}, expected {} to {}", name, value, low, high));
}

Result<void> checkOptions(const PlanOptions& options) {
  if (options.radiusMetres) {
    if (auto checked = checkRange("radius", *options.radiusMetres, 0.05, 5.0); !checked) return checked;
  }
  if (auto checked = checkRange("goal radius", options.goalRadiusMetres, 0.01, 5.0); !checked) return checked;
  if (auto checked = checkRange("subgoal spacing", options.subgoalSpacingMetres, 0.2, 20.0); !checked)
    return checked;
  return checkRange("budget in milliseconds", options.budgetMilliseconds, 0.0, 1e9);
}

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

/// What is known of a library before any plan.
struct Prepared {
  const MotionLibrary& library;
  const SearchTables& tables;
  const FootCleanup& feet;
  const SourceFigures& sources;
};

/// One plan in the making: each stage fills in its part.
class Planning {
 public:
  Planning(const Prepared& prepared, const Scene& scene, const PlanOptions& options)
      : library_(prepared.library),
        prepared_(prepared),
        scene_(scene),
        options_(options),
        total_(options.clock) {
    PlanReport& report = plan_.report;
    report.seed = options.seed.value_or(scene.seed);
    report.planner = options.planner;
    report.search = options.search;
    report.radiusMetres = options.radiusMetres.value_or(scene.radiusMetres);
    report.goalRadiusMetres = options.goalRadiusMetres;
    report.unitsPerMetre = library_.layout.unitsPerMetre;
    report.libraryHash = library_.hash;
  }

  Plan run() {
    const FloorPlan floor(scene_, plan_.report.radiusMetres);
    findPath(floor);
    if (plan_.report.status == PlanStatus::kArrived) {
      const MotionPath motion = findMotion(floor);
      if (plan_.report.status == PlanStatus::kArrived) makeWalk(floor, motion);
    }
    plan_.report.totalMilliseconds = total_.elapsed();
    return std::move(plan_);
  }

 private:
  void findPath(const FloorPlan& floor) {
    const Stopwatch watch(options_.clock);
    PathResult found =
        planPath(floor, scene_.start.position, scene_.goal.position, options_.planner, plan_.report.seed);
    plan_.report.status = statusOf(found.status);
    plan_.report.explanation = explainPath(plan_.report.status, floor.radiusMetres());
    plan_.report.pathLengthMetres = found.lengthMetres;
    plan_.roadmap = std::move(found.roadmapEdges);
    plan_.path = std::move(found.path);
    field_ = std::move(found.field);
    if (!plan_.path.empty()) plan_.subgoals = subgoals(plan_.path, options_.subgoalSpacingMetres);
    plan_.report.pathMilliseconds = watch.elapsed();
  }

  MotionPath findMotion(const FloorPlan& floor) {
    const Stopwatch watch(options_.clock);
    const MotionQuery query{
        library_,
        prepared_.tables,
        floor,
        scene_.start,
        scene_.goal,
        options_.goalRadiusMetres,
        kGoalTurn,
        plan_.path,
        plan_.subgoals,
        options_.standing,
        plan_.report.seed,
        [&](const MotionPath& path) {
          return bendToGoal(placementsAlong(library_, path), scene_.goal, floor).has_value();
        },
        options_.improvementExpansions,
        [&] { return options_.budgetMilliseconds > 0.0 && watch.elapsed() > options_.budgetMilliseconds; },
        field_.get()};
    MotionResult found = searchMotion(options_.search, query);
    plan_.report.status = statusOf(found.status);
    plan_.report.explanation = std::move(found.explanation);
    plan_.report.expansions = found.expansions;
    plan_.report.motionMilliseconds = watch.elapsed();
    return std::move(found.path);
  }

  void makeWalk(const FloorPlan& floor, const MotionPath& motion) {
    const Stopwatch watch(options_.clock);
    SynthesisedWalk made = synthesise(library_, motion);
    PlanReport& report = plan_.report;
    const std::vector<FloorTransform>& way = made.placements;
    if (report.search == SearchKind::kGuided) {
      if (const std::optional<BentWay> bent = bendToGoal(way, scene_.goal, floor)) {
        moveRoots(way, bent->placements, made.clip);
        report.arrivalWarp = bent->warp;
        if (bent->warp.metres > 0.0) plan_.unbentWay = way;
      }
    }
    if (options_.footCleanup) cleanFeet(made);
    measurePlan(
        {library_, prepared_.tables.graph, prepared_.sources, floor, scene_, options_, motion, made.clip},
        report);
    plan_.walk = std::move(made.clip);
    plan_.frameKinds = std::move(made.frameKinds);
    plan_.contacts = std::move(made.contacts);
    report.synthesisMilliseconds = watch.elapsed();
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
  Stopwatch total_;
  std::shared_ptr<const DistanceField> field_;  ///< Of the planner, where it has one.
  Plan plan_;
};

}  // namespace

WalkPlanner::WalkPlanner(std::shared_ptr<const MotionLibrary> library)
    : library_(std::move(library)),
      tables_(*library_),
      feet_(*library_),
      sources_(sourceFigures(*library_)) {}

Result<Plan> WalkPlanner::plan(const Scene& scene, const PlanOptions& options) const {
  if (auto checked = checkScene(scene); !checked) return fail(std::move(checked));
  if (auto checked = checkOptions(options); !checked) return fail(std::move(checked));
  const Prepared prepared{*library_, tables_, feet_, sources_};
  return Planning(prepared, scene, options).run();
}

}  // namespace stridegraph
