#include "motion/transition_blend.h"

#include <algorithm>

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

/// The time at which a clip is read at a step of a blend.
ClipTime timeIn(const ClipSpan& span, const TransitionBlend& blend, std::size_t step) {
  const std::size_t steps = blend.frames - 1;
  const std::size_t sourceSpan = blend.source.last - blend.source.first;
  const std::size_t targetSpan = blend.target.last - blend.target.first;
  // Spans that need no warp hit frames exactly.
  if (sourceSpan == steps && targetSpan == steps) return {span.first + step, 0.0};
  const double place =
      blendProgress(sourceSpan, targetSpan, steps, step) * static_cast<double>(span.last - span.first);
  const auto whole = static_cast<std::size_t>(place);
  const std::size_t frame = std::min(span.first + whole, span.last);
  return {frame, frame == span.last ? 0.0 : place - static_cast<double>(whole)};
}

FloorTransform placementAt(const Clip& clip, const ClipTime& time) {
  const FloorTransform here = rootPlacement(clip.pose(time.frame));
  if (time.fraction == 0.0) return here;
  return interpolate(here, rootPlacement(clip.pose(time.frame + 1)), time.fraction);
}

std::vector<FloorTransform> placements(const ClipSpan& span, const TransitionBlend& blend) {
  std::vector<FloorTransform> track;
  track.reserve(blend.frames);
  for (std::size_t step = 0; step < blend.frames; ++step)
    track.push_back(placementAt(*span.clip, timeIn(span, blend, step)));
  return track;
}

void checkSpan(const ClipSpan& span) {
  STRIDEGRAPH_CHECK(span.clip != nullptr);
  STRIDEGRAPH_CHECK(span.first < span.last && span.last < span.clip->frameCount());
}

}  // namespace

double blendProgress(std::size_t sourceSpan, std::size_t targetSpan, std::size_t steps, std::size_t step) {
  // Slopes of a monotone cubic are at most three times the mean slope.
  constexpr double kSteepest = 3.0;
  const auto count = static_cast<double>(steps);
  const double atSource = std::min(kSteepest, count / static_cast<double>(sourceSpan));
  const double atTarget = std::min(kSteepest, count / static_cast<double>(targetSpan));
  const double x = static_cast<double>(step) / count;
  const double left = 1.0 - x;
  return x * (left * left * atSource + x * (3.0 - 2.0 * x - left * atTarget));
}

FloorTransform rootPlacement(const PoseView& pose) {
  return {onFloor(pose.rootPosition), headingOf(pose.rotations[0])};
}

std::vector<FloorTransform> blendTrack(const TransitionBlend& blend) {
  checkSpan(blend.source);
  checkSpan(blend.target);
  STRIDEGRAPH_CHECK(blend.frames >= 2);
  const std::size_t steps = blend.frames - 1;
  const double stepShare = 1.0 / static_cast<double>(steps);
  const std::vector<FloorTransform> source = placements(blend.source, blend);
  const std::vector<FloorTransform> target = placements(blend.target, blend);
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

BlendedPoses::BlendedPoses(const TransitionBlend& blend) : blend_(blend), track_(blendTrack(blend)) {
  STRIDEGRAPH_CHECK(blend.target.clip->jointCount == blend.source.clip->jointCount);
}

void BlendedPoses::pose(std::size_t frame, Vec3& rootPosition, std::span<Quat> rotations) const {
  STRIDEGRAPH_CHECK(rotations.size() == blend_.source.clip->jointCount);
  const auto steps = static_cast<double>(blend_.frames - 1);
  const double share = eased(blend_.params.ease, static_cast<double>(frame) / steps);
  const Sample source{blend_.source.clip, timeIn(blend_.source, blend_, frame)};
  const Sample target{blend_.target.clip, timeIn(blend_.target, blend_, frame)};
  const Vec2& floor = track_[frame].translation;
  rootPosition = {floor.x(), source.height() + (target.height() - source.height()) * share, floor.y()};
  rotations[0] = track_[frame].heading.rotation() * slerp(source.tilt(), target.tilt(), share);
  for (std::size_t j = 1; j < rotations.size(); ++j)
    rotations[j] = slerp(source.joint(j), target.joint(j), share);
}

Clip blendPoses(const TransitionBlend& blend) {
  const BlendedPoses blended(blend);
  const std::size_t jointCount = blend.source.clip->jointCount;
  Clip clip{.name = {},
            .framesPerSecond = blend.source.clip->framesPerSecond,
            .jointCount = jointCount,
            .rootPositions = std::vector<Vec3>(blend.frames),
            .rotations = std::vector<Quat>(blend.frames * jointCount)};
  for (std::size_t f = 0; f < blend.frames; ++f) blended.pose(f, clip.rootPositions[f], clip.rotationsOf(f));
  return clip;
}

}  // namespace stridegraph
