#include "motion/resample.h"

#include <cmath>

#include "base/check.h"
#include "math/rotation.h"

namespace stridegraph {
namespace {

/// Moments this near to a frame, in frames, are that frame: products of rates are not exact.
constexpr double kSameMoment = 1e-6;

Pose poseBetween(const PoseView& from, const PoseView& to, double fraction) {
  Pose pose;
  pose.rootPosition = from.rootPosition + (to.rootPosition - from.rootPosition) * fraction;
  pose.rotations.reserve(from.rotations.size());
  for (std::size_t j = 0; j < from.rotations.size(); ++j) {
    pose.rotations.push_back(slerp(from.rotations[j], to.rotations[j], fraction));
  }
  return pose;
}

}  // namespace

void makeSignsContinuous(Clip& clip) {
  for (std::size_t i = clip.jointCount; i < clip.rotations.size(); ++i) {
    Quat& rotation = clip.rotations[i];
    if (clip.rotations[i - clip.jointCount].dot(rotation) < 0.0) rotation.coeffs() *= -1.0;
  }
}

std::size_t resampledFrameCount(std::size_t frameCount, double fromFramesPerSecond,
                                double toFramesPerSecond) {
  if (frameCount == 0) return 0;
  const double ratio = fromFramesPerSecond / toFramesPerSecond;
  const auto last = static_cast<double>(frameCount - 1);
  return static_cast<std::size_t>(std::floor(last / ratio + kSameMoment)) + 1;
}

Clip resample(const Clip& clip, double framesPerSecond) {
  STRIDEGRAPH_CHECK(framesPerSecond > 0.0);
  Clip result;
  result.name = clip.name;
  result.framesPerSecond = framesPerSecond;
  result.jointCount = clip.jointCount;
  if (clip.frameCount() == 0) return result;
  const double ratio = clip.framesPerSecond / framesPerSecond;
  const auto last = static_cast<double>(clip.frameCount() - 1);
  const std::size_t frames = resampledFrameCount(clip.frameCount(), clip.framesPerSecond, framesPerSecond);
  result.rootPositions.reserve(frames);
  result.rotations.reserve(frames * clip.jointCount);
  for (std::size_t i = 0; i < frames; ++i) {
    const double moment = std::min(static_cast<double>(i) * ratio, last);
    const double nearest = std::round(moment);
    if (std::abs(moment - nearest) < kSameMoment) {
      result.append(clip.pose(static_cast<std::size_t>(nearest)));
      continue;
    }
    const auto before = static_cast<std::size_t>(moment);
    const double fraction = moment - static_cast<double>(before);
    result.append(poseBetween(clip.pose(before), clip.pose(before + 1), fraction).view());
  }
  makeSignsContinuous(result);
  return result;
}

}  // namespace stridegraph
