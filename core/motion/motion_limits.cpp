#include "motion/motion_limits.h"

#include <algorithm>
#include <cmath>
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

/// Factor by which bounds are widened for rounding.
constexpr double kRoundingMargin = 1.0 + 1e-9;

/// Half a turn's rotation vector, roughly: its sine part s of length |s| <= 0.5 is shorter than the vector by
/// less than 0.095 |s|^2 (asin(x) <= x + 0.19 x^3 there). Longer ones tell nothing.
struct HalfTurn {
  Vec3 sine = Vec3::Zero();
  double slack = std::numeric_limits<double>::infinity();
};

HalfTurn halfTurn(const Quat& from, const Quat& to) {
  const Quat turn = from.conjugate() * to;
  HalfTurn half;
  half.sine = turn.w() < 0.0 ? Vec3(-turn.vec()) : Vec3(turn.vec());
  const double squared = half.sine.squaredNorm();
  if (squared <= 0.25) half.slack = 0.095 * squared;
  return half;
}

/// Whether a vector that is longer than this one, but by less than `slack`, is shorter than `bound`.
bool staysBelow(double bound, const Vec3& vector, double slack) {
  const double rest = bound - slack;
  return rest > 0.0 && vector.squaredNorm() < rest * rest;
}

/// Limits as bounds of half turns from frame to frame, and of their changes.
std::vector<double> perFrame(const std::vector<double>& limits, double perSecond) {
  std::vector<double> bounds;
  bounds.reserve(limits.size());
  for (const double limit : limits) bounds.push_back(limit / (2.0 * perSecond * kRoundingMargin));
  return bounds;
}

Vec3 turnVelocity(const Clip& clip, std::size_t frame, std::size_t joint) {
  const Quat& from = clip.rotations[frame * clip.jointCount + joint];
  const Quat& to = clip.rotations[(frame + 1) * clip.jointCount + joint];
  return toRotationVector(from.conjugate() * to) * clip.framesPerSecond;
}

/// Keeps the worst; of equal ones that of the first joint, and then the first frame.
void keepWorst(double ratio, std::size_t frame, std::size_t joint, WorstRatio& worst) {
  if (ratio < worst.ratio || ratio == 0.0) return;
  if (ratio == worst.ratio &&
      (joint > worst.joint.value || (joint == worst.joint.value && frame >= worst.frame)))
    return;
  worst = {ratio, frame, JointIndex(joint)};
}

/// Calls onSpeed and onAcceleration(ratio, frame, joint) for all turns of a span but those that are surely
/// below the ratios that bounds() tells for speed and acceleration: arc tangents are taken only where a bound
/// says that they matter.
template <typename Bounds, typename OnSpeed, typename OnAcceleration>
void visitTurns(const MotionLimits& limits, const ClipSpan& span, const Bounds& bounds,
                const OnSpeed& onSpeed, const OnAcceleration& onAcceleration) {
  const Clip& clip = *span.clip;
  STRIDEGRAPH_CHECK(limits.speeds.size() == clip.jointCount);
  const std::vector<double> speeds = perFrame(limits.speeds, clip.framesPerSecond);
  const std::vector<double> accelerations =
      perFrame(limits.accelerations, clip.framesPerSecond * clip.framesPerSecond);
  std::vector<HalfTurn> before(clip.jointCount);
  for (std::size_t f = span.first; f < span.last; ++f) {
    const Quat* const here = clip.rotations.data() + f * clip.jointCount;
    for (std::size_t j = 1; j < clip.jointCount; ++j) {
      const HalfTurn half = halfTurn(here[j], here[clip.jointCount + j]);
      if (!staysBelow(bounds().first * speeds[j], half.sine, half.slack))
        onSpeed(turnVelocity(clip, f, j).norm() / limits.speeds[j], f + 1, j);
      const double bound = bounds().second * accelerations[j];
      if (f > span.first && !staysBelow(bound, half.sine - before[j].sine, half.slack + before[j].slack)) {
        const double acceleration =
            (turnVelocity(clip, f, j) - turnVelocity(clip, f - 1, j)).norm() * clip.framesPerSecond;
        onAcceleration(acceleration / limits.accelerations[j], f, j);
      }
      before[j] = half;
    }
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
  visitTurns(
      limits, wholeOf(clip), [&] { return std::pair(worst.speed.ratio, worst.acceleration.ratio); },
      [&](double ratio, std::size_t frame, std::size_t joint) {
        keepWorst(ratio, frame, joint, worst.speed);
      },
      [&](double ratio, std::size_t frame, std::size_t joint) {
        keepWorst(ratio, frame, joint, worst.acceleration);
      });
  return worst;
}

void visitRatios(const MotionLimits& limits, const ClipSpan& span, double least,
                 const std::function<void(std::size_t, double)>& visit) {
  const auto tell = [&](double ratio, std::size_t frame, std::size_t) {
    if (ratio > least) visit(frame, ratio);
  };
  visitTurns(
      limits, span, [&] { return std::pair(least, least); }, tell, tell);
}

}  // namespace stridegraph
