#include "gait_fit/lean.h"

#include <cmath>
#include <numbers>

#include "gait_fit/channels.h"
#include "motion/kinematics.h"

namespace stridegraph::gait_fit {
namespace {

constexpr double kPi = std::numbers::pi;

/// Angle of the line from a foot to the trunk to the vertical, to the left, degrees.
double leanOver(const Pose& pose, Side foot) {
  const auto points = jointPositions(gaitSkeleton(), pose.view());
  const Vec3 up = points[indexOf(GaitJoint::kThorax)] - points[gaitLeg(foot).ankle.value];
  return std::atan2(up.x(), up.y()) * 180.0 / kPi;
}

}  // namespace

std::vector<LeanSample> leanSamples(const Track& track, const GaitTable& table) {
  constexpr double kNearMiddle = 0.5;
  constexpr double kMiddleOfStance = 0.5 * kPi;
  std::vector<LeanSample> samples;
  for (Eigen::Index f = kEndFrames; f + kEndFrames < track.frames(); ++f)
    for (const Side foot : {Side::kLeft, Side::kRight}) {
      const double phase = track.phase[f] + (foot == Side::kLeft ? 0.0 : kPi);
      const double fromMiddle = std::abs(std::remainder(phase - kMiddleOfStance, 2.0 * kPi));
      if (track.going[f] <= 0.0 || fromMiddle > kNearMiddle) continue;
      const double sign = foot == Side::kLeft ? 1.0 : -1.0;
      samples.push_back({sign * track.speed[f] * track.turnRate[f],
                         sign * leanOver(poseOnPath(track, f), foot),
                         sign * leanOver(gaitPose(table, track.state(f)), foot)});
    }
  return samples;
}

LeanSlopes leanSlopes(const std::vector<LeanSample>& samples) {
  const double count = static_cast<double>(samples.size());
  LeanSample mean;
  for (const LeanSample& sample : samples) {
    mean.sideways += sample.sideways / count;
    mean.captured += sample.captured / count;
    mean.model += sample.model / count;
  }
  double spread = 0.0;
  LeanSlopes slopes;
  for (const LeanSample& sample : samples) {
    const double apart = sample.sideways - mean.sideways;
    spread += apart * apart;
    slopes.captured += apart * (sample.captured - mean.captured);
    slopes.model += apart * (sample.model - mean.model);
  }
  if (spread < 1e-9) return {};
  slopes.captured /= spread;
  slopes.model /= spread;
  return slopes;
}

}  // namespace stridegraph::gait_fit
