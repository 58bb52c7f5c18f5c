#include "graph/jerks.h"

#include <algorithm>

namespace stridegraph {
namespace {

/// The fastest step two to four steps away.
double fastestNear(const std::vector<double>& speeds, std::size_t step) {
  double fastest = 0.0;
  for (std::size_t away = 2; away <= 4; ++away) {
    if (step >= away) fastest = std::max(fastest, speeds[step - away]);
    if (step + away < speeds.size()) fastest = std::max(fastest, speeds[step + away]);
  }
  return fastest;
}

/// Whether the speed changes by too much into or out of a step that is the faster one there.
bool changesAbruptly(const TurnRates& rates, std::size_t step, double largestChange) {
  const auto isAbrupt = [&](std::size_t change, std::size_t other) {
    return rates.accelerations[change] > largestChange && rates.speeds[step] >= rates.speeds[other];
  };
  return (step > 0 && isAbrupt(step - 1, step - 1)) ||
         (step + 1 < rates.speeds.size() && isAbrupt(step, step + 1));
}

}  // namespace

std::vector<ClipSpan> clipSpans(const MotionLibrary& library) {
  std::vector<ClipSpan> spans;
  for (const LibraryClip& clip : library.clips) {
    if (clip.frameCount == 0) continue;
    spans.push_back({&library.frames, clip.firstFrame, std::size_t{clip.firstFrame} + clip.frameCount - 1});
  }
  return spans;
}

std::vector<Jerk> findJerks(const MotionLibrary& library, JointIndex joint, const JerkParams& params) {
  if (joint.value == 0) return {};
  const std::vector<ClipSpan> spans = clipSpans(library);
  const std::vector<TurnRates> ratesOfClips = turnRates(spans, joint);
  const JointLimit limit = jointLimit(ratesOfClips);
  std::vector<Jerk> jerks;
  for (std::size_t c = 0; c < spans.size(); ++c) {
    const TurnRates& rates = ratesOfClips[c];
    for (std::size_t step = 0; step < rates.speeds.size(); ++step) {
      const double speed = rates.speeds[step];
      const bool isTooMuch = speed > params.ratio * limit.speed ||
                             changesAbruptly(rates, step, params.ratio * limit.acceleration);
      if (!isTooMuch || speed <= params.factor * fastestNear(rates.speeds, step)) continue;
      jerks.push_back(
          {FrameIndex(spans[c].first + step), joint, Angle::radians(speed / library.frames.framesPerSecond)});
    }
  }
  return jerks;
}

std::vector<Jerk> findJerks(const MotionLibrary& library) {
  std::vector<Jerk> jerks;
  for (std::size_t j = 0; j < library.skeleton.size(); ++j) {
    const std::vector<Jerk> ofJoint = findJerks(library, JointIndex(j));
    jerks.insert(jerks.end(), ofJoint.begin(), ofJoint.end());
  }
  return farthestByFrame(std::move(jerks));
}

std::vector<Jerk> farthestByFrame(std::vector<Jerk> jerks) {
  std::sort(jerks.begin(), jerks.end(), [](const Jerk& a, const Jerk& b) {
    if (a.frame != b.frame) return a.frame < b.frame;
    return a.turn != b.turn ? a.turn > b.turn : a.joint < b.joint;
  });
  const auto end = std::unique(jerks.begin(), jerks.end(),
                               [](const Jerk& a, const Jerk& b) { return a.frame == b.frame; });
  jerks.erase(end, jerks.end());
  return jerks;
}

std::vector<std::uint32_t> steadyFrameCounts(const MotionLibrary& library, std::span<const Jerk> jerks) {
  std::vector<std::uint32_t> counts;
  auto jerk = jerks.begin();
  for (const LibraryClip& clip : library.clips) {
    std::uint32_t first = clip.firstFrame;
    for (; jerk != jerks.end() && jerk->frame.value < clip.firstFrame + clip.frameCount; ++jerk) {
      counts.push_back(jerk->frame.value + 1 - first);
      first = jerk->frame.value + 1;
    }
    counts.push_back(clip.firstFrame + clip.frameCount - first);
  }
  return counts;
}

bool playsAcross(std::span<const Jerk> jerks, FrameIndex first, FrameIndex last) {
  const auto jerk = std::lower_bound(jerks.begin(), jerks.end(), first,
                                     [](const Jerk& one, FrameIndex frame) { return one.frame < frame; });
  return jerk != jerks.end() && jerk->frame < last;
}

bool blendsAcross(std::span<const Jerk> jerks, const FrameTransition& transition) {
  const std::size_t from = transition.from.value;
  const std::size_t to = transition.to.value;
  return playsAcross(jerks, FrameIndex(from), FrameIndex(from + transition.sourceSpan)) ||
         playsAcross(jerks, FrameIndex(to - transition.targetSpan), FrameIndex(to));
}

}  // namespace stridegraph
