#include "gait_fit/table.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "math/rotation.h"
#include "motion/mirror.h"

namespace stridegraph::gait_fit {
namespace {

using Eigen::Index;

constexpr double kStillMetresPerSecond = 0.12;

bool fillCurve(const Series& series, Index channel, GaitCurve& curve) {
  for (std::size_t r = 0; r < curve.size(); ++r)
    for (std::size_t t = 0; t < curve[r].size(); ++t) {
      const double value = std::round(
          series.coefficients(static_cast<Index>(r * kGaitTermCount + t), channel) / kGaitTableUnit);
      if (!(std::abs(value) <= std::numeric_limits<std::int16_t>::max())) return false;
      curve[r][t] = static_cast<std::int16_t>(value);
    }
  return true;
}

double rounded(double value, int digits) {
  const double scale = std::pow(10.0, digits);
  return std::round(value * scale) / scale;
}

std::array<double, 4> roundedQuaternion(const Quat& rotation) {
  const double sign = rotation.w() < 0.0 ? -1.0 : 1.0;
  std::array<double, 4> result = {rotation.w(), rotation.x(), rotation.y(), rotation.z()};
  for (double& part : result) part = rounded(sign * part, 5) + 0.0;
  return result;
}

/// Sums rotation vectors about the mean of all until it settles (Karcher).
Quat meanOf(const std::vector<Quat>& rotations) {
  Quat mean = rotations.front();
  constexpr int kRounds = 12;
  for (int round = 0; round < kRounds; ++round) {
    Vec3 sum = Vec3::Zero();
    for (const Quat& rotation : rotations) sum += toRotationVector(mean.conjugate() * rotation);
    mean = (mean * fromRotationVector(sum / static_cast<double>(rotations.size()))).normalized();
  }
  return mean;
}

bool isStill(const Clip& clip, std::size_t f) {
  const Vec2 step = onFloor(clip.rootPositions[f + 1]) - onFloor(clip.rootPositions[f]);
  return step.norm() * clip.framesPerSecond < kStillMetresPerSecond;
}

}  // namespace

Result<GaitTable> tableOf(const Series& series, const SideLaws& laws, double reach) {
  GaitTable table{};
  table.referenceSpeed = series.referenceSpeed;
  for (std::size_t k = 0; k < laws.cadence.size(); ++k) table.cadence[k] = rounded(laws.cadence[k], 4);
  for (std::size_t k = 0; k < laws.slip.size(); ++k) table.slip[k] = rounded(laws.slip[k], 4);
  for (std::size_t k = 0; k < laws.contacts.size(); ++k) {
    const ContactKnot& knot = laws.contacts[k];
    table.contacts[k] = {rounded(knot.speedMetresPerSecond, 4), rounded(knot.onPhase, 4),
                         rounded(knot.offPhase, 4)};
  }
  table.heelInFoot = heelInFoot(laws.flatFootPitch);
  for (double& part : table.heelInFoot) part = rounded(part, 5);
  table.reach = reach;
  bool fits = true;
  for (std::size_t j = 0; j < kStoredJointCount; ++j) {
    table.means[j] = roundedQuaternion(series.means[j]);
    for (std::size_t axis = 0; axis < 3; ++axis)
      fits = fillCurve(series, static_cast<Index>(3 * j + axis), table.joints[j][axis]) && fits;
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    fits = fillCurve(series, kRotationChannels + static_cast<Index>(axis), table.offsets[axis]) && fits;
  if (!fits)
    return fail(
        ErrorCode::kInvalidArgument,
        fmt::format("found a coefficient beyond {:g} rad or m, expected smaller ones: the clips do not go "
                    "alike",
                    std::numeric_limits<std::int16_t>::max() * kGaitTableUnit));
  return table;
}

Result<StandingTable> measureStanding(std::span<const Clip> clips) {
  std::array<std::vector<Quat>, kStoredJointCount> ofClips;
  double heights = 0.0;
  for (const Clip& clip : clips) {
    std::array<std::vector<Quat>, kStoredJointCount> samples;
    double height = 0.0;
    for (std::size_t f = 0; f + 1 < clip.frameCount(); ++f) {
      if (!isStill(clip, f)) continue;
      const PoseView view = clip.pose(f);
      Pose pose{view.rootPosition, {view.rotations.begin(), view.rotations.end()}};
      pose.rotations[0] = separateHeading(pose.rotations[0]).tilt;
      const Pose twin = mirrored(pose);
      for (std::size_t j = 0; j < kStoredJointCount; ++j) {
        const std::size_t joint = indexOf(gaitJointOf(static_cast<StoredJoint>(j)));
        samples[j].push_back(pose.rotations[joint]);
        samples[j].push_back(twin.rotations[joint]);
      }
      height += view.rootPosition.y();
    }
    if (samples[0].empty()) continue;
    heights += 2.0 * height / static_cast<double>(samples[0].size());
    for (std::size_t j = 0; j < kStoredJointCount; ++j) ofClips[j].push_back(meanOf(samples[j]));
  }
  if (ofClips[0].empty())
    return fail(
        ErrorCode::kInvalidArgument,
        fmt::format("found nobody who stands still (slower than {:g} m/s), expected a clip that begins or "
                    "ends standing",
                    kStillMetresPerSecond));
  StandingTable table{};
  table.heightMetres = rounded(heights / static_cast<double>(ofClips[0].size()), 4);
  for (std::size_t j = 0; j < kStoredJointCount; ++j)
    table.rotations[j] = roundedQuaternion(meanOf(ofClips[j]));
  return table;
}

}  // namespace stridegraph::gait_fit
