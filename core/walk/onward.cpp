#include "walk/onward.h"

#include <algorithm>

namespace stridegraph {
namespace {

/// A walk turns off no sooner than so many frames after the one that is shown.
constexpr std::size_t kLeadFrames = 2;

constexpr std::size_t kFadeFrames = 10;

}  // namespace

std::optional<TurnOff> turnOff(const SearchGraph& graph, const Plan& walk, std::size_t frame) {
  std::size_t shown = 0;
  const std::vector<WalkStep>& steps = walk.motion.steps;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const WalkStep& step = steps[i];
    shown += step.end - step.begin;
    if (shown < frame + kLeadFrames || step.end != step.piece.frames) continue;
    const std::uint32_t node = graph.decisionAt(step.piece.to);
    if (node == SearchEdge::kNone) continue;
    return TurnOff{{node, walk.way[shown], static_cast<std::uint32_t>(shown)},
                   {steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(i) + 1}};
  }
  return std::nullopt;
}

MotionPath joined(std::vector<WalkStep> steps, const MotionPath& rest, const FloorTransform& start) {
  steps.insert(steps.end(), rest.steps.begin(), rest.steps.end());
  return {start, std::move(steps)};
}

std::vector<FloorTransform> replaced(std::span<const FloorTransform> way, std::size_t frame,
                                     std::span<const FloorTransform> rest) {
  std::vector<FloorTransform> whole(way.begin(), way.begin() + static_cast<std::ptrdiff_t>(frame));
  whole.insert(whole.end(), rest.begin(), rest.end());
  return whole;
}

void fadeFrom(const Clip& before, std::size_t frame, Clip& walk) {
  const std::size_t end = std::min({frame + kFadeFrames, before.frameCount(), walk.frameCount()});
  for (std::size_t f = 0; f < end; ++f) {
    const double share =
        f < frame ? 0.0 : static_cast<double>(f - frame + 1) / static_cast<double>(kFadeFrames + 1);
    walk.rootPositions[f] = (1.0 - share) * before.rootPositions[f] + share * walk.rootPositions[f];
    const std::span<const Quat> from = before.rotationsOf(f);
    const std::span<Quat> to = walk.rotationsOf(f);
    for (std::size_t j = 0; j < to.size(); ++j) to[j] = from[j].slerp(share, to[j]);
  }
}

}  // namespace stridegraph
