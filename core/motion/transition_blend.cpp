#include "motion/transition_blend.h"

#include "base/check.h"
#include "math/rotation.h"

namespace stridegraph {
namespace {

/// A moment of a clip: `fraction` of the way from `frame` to the next.
struct ClipTime {
  std::size_t frame = 0;
  double fraction = 0.0;
};

/// The tilt, height and joints of a clip at a moment, read through the clip.
struct Sample {
  const Clip* clip;
  ClipTime time;

  Quat joint(std::size_t index) const {
    const Quat& here = clip->rotations[time.frame * clip->jointCount + index];
    if (time.fraction == 0.0) return here;
    return slerp(here, clip->rotations[(time.frame + 1) * clip->jointCount + index], time.fraction);
  }
  Quat tilt() const {
    const Quat here = separateHeading(clip->rotations[time.frame * clip->jointCount]).tilt;
    if (time.fraction == 0.0) return here;
    return slerp(here, separateHeading(clip->rotations[(time.frame + 1) * clip->jointCount]).tilt,
                 time.fraction);
  }
  double height() const {
    const double here = clip->rootPositions[time.frame].y();
    if (time.fraction == 0.0) return here;
    return here + (clip->rootPositions[time.frame + 1].y() - here) * time.fraction;
  }
};

FloorTransform interpolate(const FloorTransform& from, const FloorTransform& to, double fraction) {
  return {from.translation + (to.translation - from.translation) * fraction,
          blend(from.heading, to.heading, fraction)};
}

double eased(BlendEase ease, double share) {
  if (ease == BlendEase::kLinear) return share;
  return share * share * (3.0 - 2.0 * share);
}

/// Where in `span` step `step` of `steps` falls; whole numbers, so that equal spans hit frames exactly.
ClipTime timeAt(const ClipSpan& span, std::size_t step, std::size_t steps) {
  const std::size_t scaled = step * (span.last - span.first);
  return {span.first + scaled / steps, static_cast<double>(scaled % steps) / static_cast<double>(steps)};
}

FloorTransform placementAt(const Clip& clip, const ClipTime& time) {
  const FloorTransform here = rootPlacement(clip.pose(time.frame));
  if (time.fraction == 0.0) return here;
  return interpolate(here, rootPlacement(clip.pose(time.frame + 1)), time.fraction);
}

std::vector<FloorTransform> placements(const ClipSpan& span, std::size_t steps) {
  std::vector<FloorTransform> track;
  track.reserve(steps + 1);
  for (std::size_t step = 0; step <= steps; ++step)
    track.push_back(placementAt(*span.clip, timeAt(span, step, steps)));
  return track;
}

void checkSpan(const ClipSpan& span) {
  STRIDEGRAPH_CHECK(span.clip != nullptr);
  STRIDEGRAPH_CHECK(span.first < span.last && span.last < span.clip->frameCount());
}

}  // namespace

FloorTransform rootPlacement(const PoseView& pose) {
  return {onFloor(pose.rootPosition), separateHeading(pose.rotations[0]).heading};
}

std::vector<FloorTransform> blendTrack(const TransitionBlend& blend) {
  checkSpan(blend.source);
  checkSpan(blend.target);
  STRIDEGRAPH_CHECK(blend.frames >= 2);
  const std::size_t steps = blend.frames - 1;
  const double stepShare = 1.0 / static_cast<double>(steps);
  const std::vector<FloorTransform> source = placements(blend.source, steps);
  const std::vector<FloorTransform> target = placements(blend.target, steps);
  std::vector<FloorTransform> track = {source.front()};
  track.reserve(blend.frames);
  const FloorTransform sourceFromTarget = source.front() * target.front().inverse();
  for (std::size_t step = 0; step < steps; ++step) {
    if (blend.params.root == RootBlend::kPlain) {
      const double share = eased(blend.params.ease, static_cast<double>(step + 1) * stepShare);
      track.push_back(interpolate(source[step + 1], sourceFromTarget * target[step + 1], share));
      continue;
    }
    // The share in the middle of the step, so that source and target count alike over the whole blend.
    const double share = eased(blend.params.ease, (static_cast<double>(step) + 0.5) * stepShare);
    const FloorTransform change = interpolate(source[step].inverse() * source[step + 1],
                                              target[step].inverse() * target[step + 1], share);
    track.push_back(track.back() * change);
  }
  return track;
}

Clip blendPoses(const TransitionBlend& blend) {
  const std::vector<FloorTransform> track = blendTrack(blend);
  const std::size_t jointCount = blend.source.clip->jointCount;
  STRIDEGRAPH_CHECK(blend.target.clip->jointCount == jointCount);
  Clip clip{.name = {},
            .framesPerSecond = blend.source.clip->framesPerSecond,
            .jointCount = jointCount,
            .rootPositions = {},
            .rotations = {}};
  const std::size_t steps = blend.frames - 1;
  Pose pose;
  pose.rotations.resize(jointCount);
  for (std::size_t step = 0; step <= steps; ++step) {
    const double share = eased(blend.params.ease, static_cast<double>(step) / static_cast<double>(steps));
    const Sample source{blend.source.clip, timeAt(blend.source, step, steps)};
    const Sample target{blend.target.clip, timeAt(blend.target, step, steps)};
    const Vec2& floor = track[step].translation;
    pose.rootPosition = {floor.x(), source.height() + (target.height() - source.height()) * share, floor.y()};
    pose.rotations[0] = track[step].heading.rotation() * slerp(source.tilt(), target.tilt(), share);
    for (std::size_t j = 1; j < jointCount; ++j)
      pose.rotations[j] = slerp(source.joint(j), target.joint(j), share);
    clip.append(pose.view());
  }
  return clip;
}

}  // namespace stridegraph
