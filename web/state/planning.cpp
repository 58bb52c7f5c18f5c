#include "state/planning.h"
#include "walk/keeping.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace stridegraph {

namespace {

/// Planning takes at most one part in so many of the time while something is dragged.
constexpr double kShareOfDrag = 2.0;
constexpr double kPauseSeconds = 0.12;
constexpr double kLongestSearchMilliseconds = 2000.0;
/// While something is dragged: the next move brings another plan anyway.
constexpr double kLongestDragSearchMilliseconds = 150.0;
/// When the scene rests better walks are looked for: states, for all walkers together,
constexpr std::uint64_t kImprovementExpansions = 20'000;
/// so many at once,
constexpr std::uint64_t kExpansionsAtOnce = 500;
/// for some milliseconds of each frame, or a third of it where frames take long.
constexpr double kLeastSliceMilliseconds = 5.0;
constexpr double kSliceOfFrame = 0.33;

/// A body that moves by less from one pose to another does not jump.
constexpr double kJumpMetres = 0.01;
constexpr Angle kJumpTurn = Angle::degrees(2.0);

bool isDue(const AppState& state) {
  if (!state.replanning.wanted || !state.planner) return false;
  if (!state.drag) return true;
  const Replanning& when = state.replanning;
  if (state.nowSeconds - when.changedAtSeconds >= kPauseSeconds) return true;
  return state.nowSeconds - when.plannedAtSeconds >= kShareOfDrag * when.lastMilliseconds / 1000.0;
}

bool haveSameStarts(const Scene& a, const Scene& b) {
  return a.start == b.start &&
         std::equal(a.walkers.begin(), a.walkers.end(), b.walkers.begin(), b.walkers.end(),
                    [](const Walker& v, const Walker& w) { return v.start == w.start; });
}

/// The frame from which walks go on when the scene changes; nothing where they begin anew: where not all
/// arrive, at either end of the first walk, and where a start is not where it was.
std::optional<std::size_t> frameUnderWay(const AppState& state) {
  if (!state.plan || !allArrive(*state.plan)) return std::nullopt;
  const Clip& walk = state.plan->walk;
  const double frame = std::floor(state.playback.seconds * walk.framesPerSecond + 1e-6);
  const bool within = frame >= 1.0 && frame + 1.0 < static_cast<double>(walk.frameCount());
  if (!within || !haveSameStarts(state.plan->scene, state.shownScene())) return std::nullopt;
  return static_cast<std::size_t>(frame);
}

/// Shows what a plan has now, and goes on looking for better walks.
void show(AppState& state, AnytimePlan plan) {
  if (plan.isDone()) {
    state.plan = std::move(plan).best();
  } else {
    state.plan = plan.best();
    state.replanning.improving = std::move(plan);
  }
}

/// The one place where the page asks for a plan: the walk under way goes on, or all begin anew.
Result<void> followScene(AppState& state, const PlanOptions& options) {
  const Scene& scene = state.shownScene();
  if (const std::optional<std::size_t> frame = frameUnderWay(state)) {
    Result<AnytimePlan> next = state.planner->beginOnward(*state.plan, *frame, scene, options);
    if (!next) return fail(std::move(next));
    const bool stuck = !allArrive(next->best());
    state.replanning.wentOn = !stuck || state.drag;
    if (stuck && state.drag) state.troubleOnWay = next->best().report;
    if (!stuck) show(state, std::move(*next));
    // Where no way leads on from the present pose, the walk has to begin differently.
    if (!stuck || state.drag) return {};
  }
  state.replanning.wentOn = false;
  Result<AnytimePlan> plan = state.planner->begin(scene, options);
  if (!plan) return fail(std::move(plan));
  show(state, std::move(*plan));
  return {};
}

/// Whether poses of two walks at a frame look alike.
bool looksAlike(const Clip& a, const Clip& b, std::size_t frame) {
  const PoseView before = a.pose(std::min(frame, a.frameCount() - 1));
  const PoseView after = b.pose(std::min(frame, b.frameCount() - 1));
  if ((before.rootPosition - after.rootPosition).norm() > kJumpMetres) return false;
  for (std::size_t joint = 0; joint < a.jointCount; ++joint)
    if (before.rotations[joint].angularDistance(after.rotations[joint]) > kJumpTurn.radians()) return false;
  return true;
}

/// Whether another plan of all that arrive can be shown without a jump of any body on screen.
bool canBeShown(const AppState& state, const Plan& other) {
  const std::size_t frame = state.shownFrame();
  if (frame == 0) return true;
  const auto alike = [frame](const Plan& a, const Plan& b) {
    return looksAlike(a.walk, b.walk, frame) && looksAlike(a.walk, b.walk, frame + 1);
  };
  return allArrive(*state.plan) && alike(*state.plan, other) &&
         std::equal(state.plan->others.begin(), state.plan->others.end(), other.others.begin(), alike);
}

PlanOptions optionsOf(const AppState& state, const MillisecondClock& clock) {
  PlanOptions options;
  options.planner = state.settings.planner;
  options.search = state.settings.search;
  options.goalRadiusMetres = state.settings.goalRadiusMetres;
  options.budgetMilliseconds = state.drag ? kLongestDragSearchMilliseconds : kLongestSearchMilliseconds;
  if (!state.drag)
    options.improvementExpansions = kImprovementExpansions / (1 + state.shownScene().walkers.size());
  options.clock = clock;
  return options;
}

}  // namespace

void wantPlan(AppState& state) {
  state.replanning.wanted = true;
  state.replanning.changedAtSeconds = state.nowSeconds;
}

bool planWhenDue(AppState& state, const MillisecondClock& clock) {
  // A walk that went on in another scene than it began in is planned anew once it begins again.
  if (state.replanning.wentOn && !state.drag && state.shownFrame() == 0) wantPlan(state);
  if (!isDue(state)) return false;
  const double before = clock();
  state.troubleOnWay.reset();
  state.replanning.improving.reset();
  state.replanning.better.reset();
  const Result<void> followed = followScene(state, optionsOf(state, clock));
  state.planError = followed ? "" : describe(followed.error());
  if (!followed) state.plan.reset();
  state.replanning.lastMilliseconds = clock() - before;
  state.replanning.plannedAtSeconds = state.nowSeconds;
  state.replanning.wanted = false;
  ++state.replanning.generation;
  return true;
}

bool improveWalk(AppState& state, const MillisecondClock& clock, double frameSeconds) {
  Replanning& replanning = state.replanning;
  if (replanning.wanted || state.drag) return false;
  if (replanning.improving) {
    AnytimePlan& plan = *replanning.improving;
    const double until = clock() + std::max(kLeastSliceMilliseconds, kSliceOfFrame * 1000.0 * frameSeconds);
    bool better = false;
    do {
      better = plan.step(kExpansionsAtOnce) || better;
    } while (!plan.isDone() && clock() < until);
    if (better) replanning.better = plan.best();
    if (plan.isDone()) replanning.improving.reset();
  }
  if (!replanning.better || !canBeShown(state, *replanning.better)) return false;
  state.plan = std::move(*replanning.better);
  replanning.better.reset();
  ++replanning.generation;
  return true;
}

}  // namespace stridegraph
