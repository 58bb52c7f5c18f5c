#include "state/planning.h"

#include <algorithm>

namespace stridegraph {

namespace {

constexpr double kFrameMilliseconds = 16.0;
constexpr double kDragIntervalSeconds = 0.1;
constexpr double kPauseSeconds = 0.12;
constexpr double kLongestSearchMilliseconds = 2000.0;

bool isDue(const AppState& state) {
  if (!state.replanning.wanted || !state.planner) return false;
  if (!state.drag) return true;
  const Replanning& when = state.replanning;
  if (state.nowSeconds - when.changedAtSeconds >= kPauseSeconds) return true;
  return when.lastMilliseconds < kFrameMilliseconds &&
         state.nowSeconds - when.plannedAtSeconds >= kDragIntervalSeconds;
}

}  // namespace

void wantPlan(AppState& state) {
  state.replanning.wanted = true;
  state.replanning.changedAtSeconds = state.nowSeconds;
}

bool planWhenDue(AppState& state, const MillisecondClock& clock) {
  if (!isDue(state)) return false;
  PlanOptions options;
  options.planner = state.settings.planner;
  options.search = state.settings.search;
  options.goalRadiusMetres = state.settings.goalRadiusMetres;
  options.budgetMilliseconds = kLongestSearchMilliseconds;
  options.clock = clock;
  const double before = clock();
  Result<Plan> plan = state.planner->plan(state.shownScene(), options);
  state.replanning.lastMilliseconds = clock() - before;
  state.replanning.plannedAtSeconds = state.nowSeconds;
  state.replanning.wanted = false;
  ++state.replanning.generation;
  state.planError = plan ? "" : describe(plan.error());
  state.plan.reset();
  if (plan) state.plan = std::move(*plan);
  state.playback.seconds = std::min(state.playback.seconds, state.walkSeconds());
  return true;
}

}  // namespace stridegraph
