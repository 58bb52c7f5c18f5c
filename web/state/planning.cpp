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
/// When the scene rests there is a moment to look for better walks: states, for all walkers together.
constexpr std::uint64_t kImprovementExpansions = 20'000;

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

/// The one place where the page asks for a plan: the walk under way goes on, or all begin anew.
Result<void> followScene(AppState& state, const PlanOptions& options) {
  const Scene& scene = state.shownScene();
  if (const std::optional<std::size_t> frame = frameUnderWay(state)) {
    Result<Plan> next = state.planner->replan(*state.plan, *frame, scene, options);
    if (!next) return fail(std::move(next));
    const bool stuck = !allArrive(*next);
    state.replanning.wentOn = !stuck || state.drag;
    if (stuck && state.drag) state.troubleOnWay = std::move(next->report);
    if (!stuck) state.plan = std::move(*next);
    // Where no way leads on from the present pose, the walk has to begin differently.
    if (!stuck || state.drag) return {};
  }
  state.replanning.wentOn = false;
  Result<Plan> plan = state.planner->plan(scene, options);
  if (!plan) return fail(std::move(plan));
  state.plan = std::move(*plan);
  return {};
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
  const Result<void> followed = followScene(state, optionsOf(state, clock));
  state.planError = followed ? "" : describe(followed.error());
  if (!followed) state.plan.reset();
  state.replanning.lastMilliseconds = clock() - before;
  state.replanning.plannedAtSeconds = state.nowSeconds;
  state.replanning.wanted = false;
  ++state.replanning.generation;
  return true;
}

}  // namespace stridegraph
