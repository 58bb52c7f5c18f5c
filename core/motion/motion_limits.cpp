#include "motion/motion_limits.h"

#include <algorithm>
#include <limits>

#include "base/check.h"
#include "math/rotation.h"

namespace stridegraph {
namespace {

constexpr double kUsualShare = 0.999;
/// Noise of capture on joints that are held still.
constexpr double kStillSpeed = 0.5;          // rad/s
constexpr double kStillAcceleration = 15.0;  // rad/s^2

/// Between the two nearest ranks, linearly; 0 without values.
double percentile(std::vector<double>& values, double share) {
  if (values.empty()) return 0.0;
  const double rank = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), values.begin() + below, values.end());
  const double low = values[static_cast<std::size_t>(below)];
  if (below + 1 == static_cast<std::ptrdiff_t>(values.size())) return low;
  const double high = *std::min_element(values.begin() + below + 1, values.end());
  return low + (rank - static_cast<double>(below)) * (high - low);
}

/// The worst of the rates that `ratesOf` picks; the first of them lies at frame 1.
template <typename RatesOf>
WorstRatio worstOf(const std::vector<double>& limits, const Clip& clip, RatesOf&& ratesOf) {
  WorstRatio worst;
  if (clip.frameCount() == 0) return worst;
  STRIDEGRAPH_CHECK(limits.size() == clip.jointCount);
  for (std::size_t j = 1; j < clip.jointCount; ++j) {
    const TurnRates rates = turnRates(wholeOf(clip), JointIndex(j));
    const std::vector<double>& values = ratesOf(rates);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i] / limits[j] > worst.ratio) worst = {values[i] / limits[j], i + 1, JointIndex(j)};
    }
  }
  return worst;
}

}  // namespace

TurnRates turnRates(const ClipSpan& span, JointIndex joint) {
  const Clip& clip = *span.clip;
  TurnRates rates;
  Vec3 before = Vec3::Zero();
  for (std::size_t f = span.first; f < span.last; ++f) {
    const Quat turn =
        clip.pose(f).rotations[joint.value].conjugate() * clip.pose(f + 1).rotations[joint.value];
    const Vec3 velocity = toRotationVector(turn) * clip.framesPerSecond;
    rates.speeds.push_back(velocity.norm());
    if (f > span.first) rates.accelerations.push_back((velocity - before).norm() * clip.framesPerSecond);
    before = velocity;
  }
  return rates;
}

JointLimit jointLimit(std::span<const ClipSpan> clips, JointIndex joint) {
  std::vector<double> speeds;
  std::vector<double> accelerations;
  for (const ClipSpan& clip : clips) {
    const TurnRates rates = turnRates(clip, joint);
    speeds.insert(speeds.end(), rates.speeds.begin(), rates.speeds.end());
    accelerations.insert(accelerations.end(), rates.accelerations.begin(), rates.accelerations.end());
  }
  return {std::max(percentile(speeds, kUsualShare), kStillSpeed),
          std::max(percentile(accelerations, kUsualShare), kStillAcceleration)};
}

MotionLimits motionLimits(std::span<const ClipSpan> clips) {
  MotionLimits limits;
  if (clips.empty()) return limits;
  constexpr double kNone = std::numeric_limits<double>::infinity();
  limits.speeds.assign(clips.front().clip->jointCount, kNone);
  limits.accelerations.assign(clips.front().clip->jointCount, kNone);
  for (std::size_t j = 1; j < clips.front().clip->jointCount; ++j) {
    const JointLimit limit = jointLimit(clips, JointIndex(j));
    limits.speeds[j] = limit.speed;
    limits.accelerations[j] = limit.acceleration;
  }
  return limits;
}

WorstRatio worstSpeedRatio(const MotionLimits& limits, const Clip& clip) {
  return worstOf(limits.speeds, clip,
                 [](const TurnRates& rates) -> const std::vector<double>& { return rates.speeds; });
}

WorstRatio worstAccelerationRatio(const MotionLimits& limits, const Clip& clip) {
  return worstOf(limits.accelerations, clip,
                 [](const TurnRates& rates) -> const std::vector<double>& { return rates.accelerations; });
}

}  // namespace stridegraph
