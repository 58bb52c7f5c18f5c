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

/// The engine explains in a clause; people read sentences.
std::string sentenceOf(std::string clause) {
  if (clause.empty()) return clause;
  if (clause[0] >= 'a' && clause[0] <= 'z') clause[0] = static_cast<char>(clause[0] - 'a' + 'A');
  clause += '.';
  return clause;
}

}  // namespace

std::string statusSentence(const AppState& state) {
  if (!state.library) return "No motion library is loaded.";
  if (!state.planError.empty()) return state.planError;
  if (!state.plan) return "Planning the walk.";
  const PlanReport& report = state.plan->report;
  if (report.status == PlanStatus::kArrived) {
    const std::string note =
        report.explanation.empty() ? "" : fmt::format(" {}", sentenceOf(report.explanation));
    return fmt::format("Arrives after {:.1f} m in {:.1f} s.{}", report.motionLengthMetres,
                       report.durationSeconds, note);
  }
  return sentenceOf(report.explanation);
}

}  // namespace stridegraph
