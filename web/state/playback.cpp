#include "state/playback.h"

#include <algorithm>
#include <cmath>

#include "math/rotation.h"

namespace stridegraph {

namespace {

Pose between(const Clip& clip, double seconds) {
  const auto last = static_cast<double>(clip.frameCount() - 1);
  const double at = std::min(seconds * clip.framesPerSecond, last);
  const double whole = std::floor(at);
  const auto frame = static_cast<std::size_t>(whole);
  const std::size_t next = std::min(frame + 1, clip.frameCount() - 1);
  const double fraction = at - whole;
  const PoseView a = clip.pose(frame);
  const PoseView b = clip.pose(next);
  Pose pose;
  pose.rootPosition = a.rootPosition + (b.rootPosition - a.rootPosition) * fraction;
  pose.rotations.reserve(clip.jointCount);
  for (std::size_t joint = 0; joint < clip.jointCount; ++joint) {
    pose.rotations.push_back(slerp(a.rotations[joint], b.rotations[joint], fraction));
  }
  return pose;
}

Pose standingAt(const MotionLibrary& library, const Placement& start) {
  const PoseView first = library.frames.pose(0);
  const FloorTransform wanted{start.position, Heading::fromAngle(start.heading.value_or(Angle()))};
  const FloorTransform move = wanted * library.placementAt(FrameIndex(0)).inverse();
  Pose pose;
  pose.rootPosition = move.apply(first.rootPosition);
  pose.rotations.assign(first.rotations.begin(), first.rotations.end());
  pose.rotations[0] = move.heading.rotation() * pose.rotations[0];
  return pose;
}

}  // namespace

bool advance(AppState& state, double deltaSeconds) {
  if (!state.playback.playing || !state.canPlay()) return false;
  if (state.playback.seconds == 0.0 && state.replanning.improving) return false;
  const double length = state.walkSeconds();
  state.playback.seconds += deltaSeconds * state.playback.speed;
  if (state.playback.seconds <= length) return true;
  if (state.playback.loop && length > 0.0) {
    // A short rest on the last frame lets the eye see the arrival.
    constexpr double kRestSeconds = 0.8;
    if (state.playback.seconds > length + kRestSeconds) state.playback.seconds = 0.0;
    return true;
  }
  state.playback.seconds = length;
  state.playback.playing = false;
  return true;
}

Playback playToggled(const AppState& state) {
  Playback playback = state.playback;
  playback.playing = !playback.playing;
  if (playback.playing && playback.seconds >= state.walkSeconds()) playback.seconds = 0.0;
  return playback;
}

std::optional<Pose> shownPose(const AppState& state, std::size_t walker) {
  if (const Plan* const plan = state.planOf(walker); plan != nullptr && plan->walk.frameCount() > 0) {
    return between(plan->walk, state.shownSeconds());
  }
  const Scene& scene = state.shownScene();
  if (!state.library || state.library->frames.frameCount() == 0 || walker > scene.walkers.size()) {
    return std::nullopt;
  }
  return standingAt(*state.library, walker == 0 ? scene.start : scene.walkers[walker - 1].start);
}

}  // namespace stridegraph
