#include "motion/motion_limits.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/check.h"
#include "math/percentile.h"
#include "math/rotation.h"

namespace stridegraph {
namespace {

constexpr double kUsualShare = 0.999;
/// Noise of capture on joints that are held still.
constexpr double kStillSpeed = 0.5;          // rad/s
constexpr double kStillAcceleration = 15.0;  // rad/s^2

/// Keeps the worst of some rates of a joint; the first of them lies at frame 1.
void keepWorst(const std::vector<double>& rates, double limit, JointIndex joint, WorstRatio& worst) {
  for (std::size_t i = 0; i < rates.size(); ++i) {
    if (rates[i] / limit > worst.ratio) worst = {rates[i] / limit, i + 1, joint};
  }
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

std::vector<TurnRates> turnRates(std::span<const ClipSpan> clips, JointIndex joint) {
  std::vector<TurnRates> rates;
  for (const ClipSpan& clip : clips) rates.push_back(turnRates(clip, joint));
  return rates;
}

JointLimit jointLimit(std::span<const TurnRates> clips) {
  std::vector<double> speeds;
  std::vector<double> accelerations;
  for (const TurnRates& rates : clips) {
    speeds.insert(speeds.end(), rates.speeds.begin(), rates.speeds.end());
    accelerations.insert(accelerations.end(), rates.accelerations.begin(), rates.accelerations.end());
  }
  return {std::max(percentile(std::move(speeds), kUsualShare), kStillSpeed),
          std::max(percentile(std::move(accelerations), kUsualShare), kStillAcceleration)};
}

MotionLimits motionLimits(std::span<const ClipSpan> clips) {
  MotionLimits limits;
  if (clips.empty()) return limits;
  constexpr double kNone = std::numeric_limits<double>::infinity();
  limits.speeds.assign(clips.front().clip->jointCount, kNone);
  limits.accelerations.assign(clips.front().clip->jointCount, kNone);
  for (std::size_t j = 1; j < clips.front().clip->jointCount; ++j) {
    const JointLimit limit = jointLimit(turnRates(clips, JointIndex(j)));
    limits.speeds[j] = limit.speed;
    limits.accelerations[j] = limit.acceleration;
  }
  return limits;
}

WorstRatios worstRatios(const MotionLimits& limits, const Clip& clip) {
  WorstRatios worst;
  if (clip.frameCount() == 0) return worst;
  STRIDEGRAPH_CHECK(limits.speeds.size() == clip.jointCount);
  for (std::size_t j = 1; j < clip.jointCount; ++j) {
    const JointIndex joint(j);
    const TurnRates rates = turnRates(wholeOf(clip), joint);
    keepWorst(rates.speeds, limits.speeds[j], joint, worst.speed);
    keepWorst(rates.accelerations, limits.accelerations[j], joint, worst.acceleration);
  }
  return worst;
}

}  // namespace stridegraph
