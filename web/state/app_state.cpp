#include "state/app_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stridegraph {

double AppState::walkSeconds() const {
  if (!hasWalk()) return 0.0;
  return static_cast<double>(plan->walk.frameCount() - 1) / plan->walk.framesPerSecond;
}

std::size_t AppState::shownFrame() const {
  if (!hasWalk()) return 0;
  const double frame = std::floor(playback.seconds * plan->walk.framesPerSecond + 1e-6);
  return std::min(static_cast<std::size_t>(std::max(frame, 0.0)), plan->walk.frameCount() - 1);
}

namespace {

std::string plainReason(PlanStatus status) {
  switch (status) {
    case PlanStatus::kArrived:
      return "";
    case PlanStatus::kStartBlocked:
      return "The start is blocked: the body does not fit where it stands.";
    case PlanStatus::kGoalBlocked:
      return "The goal is blocked: the body does not fit there.";
    case PlanStatus::kNoPath:
      return "There is no way: every path to the goal is walled off for this body.";
    case PlanStatus::kNoMotion:
      return "There is a path, but no captured motion can follow it.";
    case PlanStatus::kBudgetSpent:
      return "The search ran out of time before it found a walk.";
  }
  return "";
}

}  // namespace

std::string statusSentence(const AppState& state) {
  if (!state.library) return "No motion library is loaded.";
  if (!state.planError.empty()) return state.planError;
  if (!state.plan) return "Planning the walk.";
  const PlanReport& report = state.plan->report;
  if (report.status == PlanStatus::kArrived) {
    return fmt::format("Arrives after {:.1f} m in {:.1f} s.", report.motionLengthMetres,
                       report.durationSeconds);
  }
  return report.explanation.empty() ? plainReason(report.status) : report.explanation;
}

}  // namespace stridegraph
