#include "state/app_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stridegraph {

const Plan* AppState::planOf(std::size_t walker) const {
  if (!plan || walker > plan->others.size()) return nullptr;
  return walker == 0 ? &*plan : &plan->others[walker - 1];
}

double AppState::walkSeconds() const {
  double longest = 0.0;
  for (std::size_t walker = 0; const Plan* const each = planOf(walker); ++walker) {
    if (each->walk.frameCount() == 0) continue;
    longest =
        std::max(longest, static_cast<double>(each->walk.frameCount() - 1) / each->walk.framesPerSecond);
  }
  return longest;
}

double AppState::shownSeconds() const {
  return canPlay() ? std::min(playback.seconds, walkSeconds()) : playback.seconds;
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

/// What becomes of several walkers: the first that does not arrive, or when the last is there and what the
/// first of whom there is something to say leaves to be wished for.
std::string sentenceForAll(const AppState& state) {
  std::string note;
  for (std::size_t walker = 0; const Plan* const each = state.planOf(walker); ++walker) {
    const PlanReport& report = each->report;
    const std::string sentence = sentenceOf(report.explanation);
    const bool namesWalkers = sentence.starts_with("Walkers ");
    const std::string said = namesWalkers ? sentence : fmt::format("Walker {}: {}", walker + 1, sentence);
    if (report.status != PlanStatus::kArrived) return said;
    if (note.empty() && !report.explanation.empty()) note = said;
  }
  return fmt::format("All {} walkers arrive, the last after {:.1f} s.{}{}", 1 + state.plan->others.size(),
                     state.walkSeconds(), note.empty() ? "" : " ", note);
}

}  // namespace

std::string statusSentence(const AppState& state) {
  if (!state.library) return "No motion library is loaded.";
  if (!state.planError.empty()) return state.planError;
  if (!state.plan) return "Planning the walk.";
  if (state.troubleOnWay) return sentenceOf(state.troubleOnWay->explanation);
  if (!state.plan->others.empty()) return sentenceForAll(state);
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
