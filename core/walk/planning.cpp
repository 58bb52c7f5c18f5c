#include "walk/planning.h"
#include "motion/resample.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "motion/resample.h"
#include "path/polyline.h"
#include "walk/near_goal.h"
#include "walk/onward.h"
#include "walk/plan_measures.h"
#include "walk/synthesis.h"

namespace stridegraph {
namespace {

/// The end of time for questions of when somebody could be somewhere: an hour at 240 frames a second.
constexpr double kLongestWayFrames = 3600.0 * 240.0;

/// How far the search may leave the walk turned from the heading asked for at the goal.
constexpr Angle kGoalTurn = Angle::degrees(10.0);

/// A walk to a near goal that drives a joint harder than this, as a share of what the clips show, is worse
/// than small steps.
constexpr double kSoundRatio = 1.8;

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

}  // namespace

/// Each stage fills in its part.
class Planning::Stages {
 public:
  Stages(const Prepared& prepared, const Scene& scene, const PlanOptions& options, const PlanTask& task)
      : library_(prepared.library),
        prepared_(prepared),
        scene_(scene),
        options_(options),
        task_(task),
        start_(task.start) {
    PlanReport& report = plan_.report;
    report.seed = options.seed.value_or(scene.seed);
    report.planner = options.planner;
    report.search = options.search;
    report.radiusMetres = task.floor.radiusMetres();
    report.goalRadiusMetres = options.goalRadiusMetres;
    report.unitsPerMetre = library_.layout.unitsPerMetre;
    report.libraryHash = library_.hash;
  }

  void findFirst() {
    if (task_.refusal) {
      plan_.report.status = task_.refusal->status;
      plan_.report.explanation = task_.refusal->explanation;
      return;
    }
    if (task_.underWay != nullptr) {
      turn_ = turnOff(prepared_.tables.graph, *task_.underWay, task_.frame);
      if (!turn_) {
        plan_.report.status = PlanStatus::kNoMotion;
        plan_.report.explanation = "the walk is in its last steps and cannot turn off any more";
        return;
      }
      start_.position = turn_->onward.placement.translation;
    }
    findPath();
    if (plan_.report.status == PlanStatus::kArrived) findMotion();
  }

  std::uint64_t expansions() const { return search_ ? search_->best().expansions : 0; }
  bool canImprove() const { return search_ && search_->canImprove(); }
  double progress() const { return search_ ? search_->progress() : 1.0; }

  bool improve(std::uint64_t expansions) {
    if (!canImprove()) return false;
    searching_.emplace(options_.clock);
    const bool better = search_->improve(expansions);
    stopSearching();
    return better;
  }

  Plan plan() const {
    Plan plan = plan_;
    PlanReport& report = plan.report;
    if (steps_) {
      makeSteps(plan);
    } else {
      if (search_) tellOf(search_->best(), plan);
      if (report.status == PlanStatus::kArrived) makeWalk(search_->best().path, plan);
    }
    update(report);
    return plan;
  }

  void update(PlanReport& report) const {
    report.expansions = expansions();
    report.motionMilliseconds = plan_.report.motionMilliseconds;
    report.totalMilliseconds =
        report.pathMilliseconds + report.motionMilliseconds + report.synthesisMilliseconds;
  }

 private:
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
      return fmt::format("{} stays at the goal",
                         task_.traffic.nearestName(task_.goal.position, Traffic::kInTheEnd));
    const double fastest = prepared_.tables.graph.fastestMetresPerFrame();
    if (!(fastest > 0.0)) return {};  // A library that only stands: the search says so.
    const double metres = (task_.goal.position - start_.position).norm() - options_.goalRadiusMetres;
    const double frames = std::min(std::max(metres, 0.0) / fastest, kLongestWayFrames);
    const std::uint32_t begun = turn_ ? turn_->onward.frame : 0;
    if (!task_.traffic.isNeverFree(task_.goal.position, near, begun + static_cast<std::uint32_t>(frames)))
      return {};
    return fmt::format(
        "{} is at the goal whenever the walk could end there",
        task_.traffic.nearestName(task_.goal.position, begun + static_cast<std::uint32_t>(frames)));
  }

  /// Small steps, where the goal is near and the body begins and ends standing.
  std::optional<StepsToGoal> smallSteps() const {
    if (options_.search != SearchKind::kGuided || !options_.standing || turn_ || !prepared_.standing)
      return std::nullopt;
    std::optional<StepsToGoal> steps =
        stepsToGoal(library_, *prepared_.standing, task_.start, task_.goal,
                    [this](std::span<const FloorTransform> way) { return isFree(way); });
    if (!steps) return std::nullopt;
    const std::optional<double>& latest = scene_.constraints.latestArrivalSeconds;
    const double seconds =
        static_cast<double>(steps->walk.placements.size() - 1) / library_.frames.framesPerSecond;
    if (latest && seconds > *latest) return std::nullopt;
    return steps;
  }

  /// Whether the walk that a search found leads to a near goal as directly as people go, and drives no joint
  /// so hard that small steps look better.
  bool isAsGoodAsSteps(const MotionResult& found) const {
    if (found.status != SearchStatus::kArrived) return false;
    if (!steps_) return true;
    Plan trial;
    trial.report = plan_.report;
    makeWalk(found.path, trial);
    return isDirect(*steps_, trial.report.motionLengthMetres) &&
           std::max(trial.report.jointSpeed.ratio, trial.report.jointAcceleration.ratio) <= kSoundRatio;
  }

  /// Whether a walk's way from its first frame on touches nothing, and nobody comes to where it ends.
  bool isFree(std::span<const FloorTransform> way) const {
    const auto end = static_cast<std::uint32_t>(way.size() - 1);
    return std::all_of(way.begin(), way.end(),
                       [this](const FloorTransform& at) { return task_.floor.isFree(at.translation); }) &&
           task_.traffic.isFree(way, 0) && task_.traffic.staysClearOfBodies(way.back().translation, end);
  }

  void findMotion() {
    searching_.emplace(options_.clock);
    if (options_.search == SearchKind::kGuided) plan_.report.explanation = takenBy();
    if (plan_.report.explanation.empty()) {
      steps_ = smallSteps();
      // Who stands there already need not look for a walk.
      if (!steps_ || !steps_->plan.steps.empty()) search_ = searchMotion(options_.search, query());
      if (search_ && isAsGoodAsSteps(search_->best())) steps_.reset();
    } else {
      plan_.report.status = PlanStatus::kGoalBlocked;
    }
    stopSearching();
  }

  MotionQuery query() {
    MotionQuery query{library_, prepared_.tables, task_.floor, start_, task_.goal};
    query.goalRadiusMetres = options_.goalRadiusMetres;
    query.goalTurn = kGoalTurn;
    query.path = plan_.path;
    query.subgoals = plan_.subgoals;
    query.standing = options_.standing;
    query.seed = plan_.report.seed;
    query.accepts = [this](const MotionPath& end, std::uint32_t first) {
      return bent(placementsAlong(library_, end), first).has_value();
    };
    if (steps_) query.costBound = steps_->costMetres;
    query.improvementExpansions = options_.improvementExpansions;
    query.enoughRatio = options_.enoughRatio;
    query.outOfTime = [this] {
      return options_.budgetMilliseconds > 0.0 &&
             plan_.report.motionMilliseconds + searching_->elapsed() > options_.budgetMilliseconds;
    };
    query.field = field_.get();
    query.traffic = &task_.traffic;
    query.constraints = &scene_.constraints;
    query.paces = &prepared_.paces;
    if (turn_) query.onward = turn_->onward;
    return query;
  }

  void stopSearching() { plan_.report.motionMilliseconds += searching_->elapsed(); }

  /// Into the plan, what the search has to say of a walk or of why there is none.
  void tellOf(const MotionResult& found, Plan& plan) const {
    plan.report.status = statusOf(found.status);
    plan.report.explanation = found.explanation;
    if (found.status == SearchStatus::kNoMotion && !turn_ && options_.standing)
      plan.report.explanation +=
          nearGoalNote(prepared_.tables, (task_.goal.position - start_.position).norm());
    if (found.way.empty()) return;
    plan.path = found.way;
    plan.subgoals = subgoals(plan.path, options_.subgoalSpacingMetres);
  }

  /// The way bent to end at the goal, where that keeps it off everything; it begins at this frame.
  std::optional<BentWay> bent(std::span<const FloorTransform> way, std::uint32_t first) const {
    std::optional<BentWay> bent = bendToGoal(way, task_.goal, task_.floor);
    if (!bent || !task_.traffic.isFree(bent->placements, first)) return std::nullopt;
    const auto end = static_cast<std::uint32_t>(first + bent->placements.size() - 1);
    if (!task_.traffic.staysClearOfBodies(bent->placements.back().translation, end)) return std::nullopt;
    return bent;
  }

  void makeWalk(const MotionPath& found, Plan& plan) const {
    const Stopwatch watch(options_.clock);
    PlanReport& report = plan.report;
    plan.motion = turn_ ? joined(turn_->steps, found, task_.underWay->motion.start) : found;
    SynthesisedWalk made = synthesise(library_, plan.motion);
    plan.way = made.placements;
    if (turn_)
      plan.way = replaced(task_.underWay->way, turn_->onward.frame, placementsAlong(library_, found));
    if (report.search == SearchKind::kGuided) bendEnd(plan);
    moveRoots(made.placements, plan.way, made.clip);
    if (options_.footCleanup) cleanFeet(made, report);
    if (turn_) fadeFrom(task_.underWay->walk, task_.frame, made.clip);
    // Seams join clips whose quaternions may differ by the sign, and headings are known up to whole turns.
    makeSignsContinuous(made.clip);
    measurePlan({library_, prepared_.tables.graph, prepared_.sources, task_.floor, scene_, task_.goal,
                 options_, plan.motion, made.clip, task_.traffic},
                report);
    plan.walk = std::move(made.clip);
    plan.frameKinds = std::move(made.frameKinds);
    plan.contacts = std::move(made.contacts);
    report.synthesisMilliseconds = watch.elapsed();
  }

  void makeSteps(Plan& plan) const {
    const Stopwatch watch(options_.clock);
    PlanReport& report = plan.report;
    const FrameIndex stand = prepared_.standing->frame;
    SynthesisedWalk made = steps_->walk;
    plan.motion = {steps_->plan.start, {WalkStep{clipPiece(stand, stand)}}};
    plan.way = made.placements;
    report.status = PlanStatus::kArrived;
    report.smallSteps = steps_->plan.steps.size();
    report.contacts = report.smallSteps + 2;
    measurePlan({library_, prepared_.tables.graph, prepared_.sources, task_.floor, scene_, task_.goal,
                 options_, plan.motion, made.clip, task_.traffic},
                report);
    addStepNote(report);
    plan.walk = std::move(made.clip);
    plan.frameKinds = std::move(made.frameKinds);
    plan.contacts = std::move(made.contacts);
    report.synthesisMilliseconds = watch.elapsed();
  }

  /// Says that steps are made up.
  static void addStepNote(PlanReport& report) {
    const std::string note =
        report.smallSteps == 0
            ? "the start is at the goal: the body stands there"
            : fmt::format("no clip leads there so directly: {} small steps are taken from a standing pose",
                          report.smallSteps);
    report.explanation = report.explanation.empty() ? note : fmt::format("{}; {}", note, report.explanation);
  }

  /// Bends what is still to be gone of the way.
  void bendEnd(Plan& plan) const {
    const std::uint32_t first = turn_ ? turn_->onward.frame : 0;
    const std::span<const FloorTransform> rest = std::span(plan.way).subspan(first);
    std::optional<BentWay> bending = bent(rest, first);
    if (!bending) return;
    plan.report.arrivalWarp = bending->warp;
    if (bending->warp.metres == 0.0) return;
    plan.unbentWay = plan.way;
    std::copy(bending->placements.begin(), bending->placements.end(),
              plan.way.begin() + static_cast<std::ptrdiff_t>(first));
  }

  void cleanFeet(SynthesisedWalk& walk, PlanReport& report) const {
    FootCleanupReport done = prepared_.feet.apply(library_, walk);
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
  std::shared_ptr<const DistanceField> field_;  ///< Of the planner, where it has one.
  Plan plan_;                                   ///< But for what the search finds.
  std::optional<Stopwatch> searching_;          ///< Since the search was last carried on.
  std::unique_ptr<MotionSearch> search_;        ///< Where there is a path.
  std::optional<StepsToGoal> steps_;            ///< To a near goal, where the search knows none better.
};

Planning::Planning(const Prepared& prepared, const Scene& scene, const PlanOptions& options,
                   const PlanTask& task)
    : stages_(std::make_unique<Stages>(prepared, scene, options, task)) {
  stages_->findFirst();
}

Planning::~Planning() = default;

std::uint64_t Planning::expansions() const {
  return stages_->expansions();
}

bool Planning::canImprove() const {
  return stages_->canImprove();
}

bool Planning::improve(std::uint64_t expansions) {
  return stages_->improve(expansions);
}

double Planning::progress() const {
  return stages_->progress();
}

Plan Planning::plan() const {
  return stages_->plan();
}

void Planning::update(PlanReport& report) const {
  stages_->update(report);
}

}  // namespace stridegraph
