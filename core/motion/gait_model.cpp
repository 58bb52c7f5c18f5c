#include "motion/gait_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/rotation.h"

namespace stridegraph {
namespace {

/// The captured body was about to start or had just stopped when it stood: knees bent by 30 degrees. Somebody
/// who waits stands up: this much higher, metres.
constexpr double kStraightening = 0.020;
/// The foot of the walk, flat on the floor.
constexpr Angle kFlatFootPitch = Angle::degrees(12.57);
constexpr double kFlatAnkleMetres = 0.0657;

/// What a curve is multiplied with.
struct CurveInput {
  std::array<double, kGaitRegressorCount> regressors;
  std::array<double, kGaitTermCount> harmonics;
};

CurveInput curveInput(const GaitTable& table, const GaitState& state) {
  return {gaitRegressors(table.referenceSpeed, state), gaitHarmonics(state.phase)};
}

double evaluate(const GaitCurve& curve, const CurveInput& input) {
  double value = 0.0;
  for (std::size_t r = 0; r < curve.size(); ++r) {
    double series = 0.0;
    for (std::size_t h = 0; h < input.harmonics.size(); ++h) series += curve[r][h] * input.harmonics[h];
    value += input.regressors[r] * series;
  }
  return value * kGaitTableUnit;
}

Quat quaternion(const std::array<double, 4>& wxyz) {
  return Quat(wxyz[0], wxyz[1], wxyz[2], wxyz[3]).normalized();
}

Quat mirrored(const Quat& q) {
  return {q.w(), q.x(), -q.y(), -q.z()};
}

Quat storedRotation(const GaitTable& table, std::size_t joint, const CurveInput& input) {
  const auto& curves = table.joints[joint];
  return quaternion(table.means[joint]) *
         fromRotationVector(
             {evaluate(curves[0], input), evaluate(curves[1], input), evaluate(curves[2], input)});
}

constexpr std::array<GaitJoint, kStoredJointCount> kStoredAs = {
    GaitJoint::kPelvis,      GaitJoint::kThorax,     GaitJoint::kHead,
    GaitJoint::kLeftFemur,   GaitJoint::kLeftTibia,  GaitJoint::kLeftFoot,
    GaitJoint::kLeftHumerus, GaitJoint::kLeftRadius, GaitJoint::kLeftHand};

/// Toes do not move in the measured clips: they point 5 degrees up from the foot.
Pose poseWithToes() {
  Pose pose{Vec3::Zero(), std::vector<Quat>(kGaitJointCount, Quat::Identity())};
  const Quat up = axisRotation(Axis::kX, Angle::degrees(-5));
  pose.rotations[indexOf(GaitJoint::kLeftToes)] = up;
  pose.rotations[indexOf(GaitJoint::kRightToes)] = up;
  return pose;
}

}  // namespace

GaitState mirrored(const GaitState& state) {
  return {state.phase + std::numbers::pi, state.speed, -state.turnRate, -state.turnAcceleration,
          state.acceleration};
}

std::array<double, kGaitRegressorCount> gaitRegressors(double referenceSpeed, const GaitState& state) {
  const double u = state.speed - referenceSpeed;
  const double w = state.turnRate;
  return {1.0,   u,    w, w * w, state.turnAcceleration, state.acceleration, w * state.turnAcceleration,
          u * w, u * u};
}

std::array<double, kGaitTermCount> gaitHarmonics(double phase) {
  std::array<double, kGaitTermCount> terms{1.0};
  for (std::size_t k = 1; k <= kGaitHarmonics; ++k) {
    const double angle = static_cast<double>(k) * phase;
    terms[2 * k - 1] = std::cos(angle);
    terms[2 * k] = std::sin(angle);
  }
  return terms;
}

GaitJoint gaitJointOf(StoredJoint joint) {
  return kStoredAs[static_cast<std::size_t>(joint)];
}

Pose gaitPose(Gait gait, const GaitState& state) {
  return gaitPose(gaitTable(gait), state);
}

Pose gaitPose(const GaitTable& table, const GaitState& state) {
  const CurveInput left = curveInput(table, state);
  const CurveInput right = curveInput(table, mirrored(state));
  Pose pose = poseWithToes();
  for (std::size_t j = 0; j < kStoredJointCount; ++j) {
    pose.rotations[indexOf(kStoredAs[j])] = storedRotation(table, j, left);
    const GaitJoint twin = otherSide(kStoredAs[j]);
    if (twin != kStoredAs[j]) pose.rotations[indexOf(twin)] = mirrored(storedRotation(table, j, right));
  }
  pose.rootPosition = {evaluate(table.offsets[0], left), evaluate(table.offsets[1], left),
                       evaluate(table.offsets[2], left)};
  return pose;
}

Pose standingPose() {
  const StandingTable& table = standingTable();
  Pose pose = poseWithToes();
  for (std::size_t j = 0; j < kStoredJointCount; ++j) {
    const Quat rotation = quaternion(table.rotations[j]);
    pose.rotations[indexOf(kStoredAs[j])] = rotation;
    const GaitJoint twin = otherSide(kStoredAs[j]);
    if (twin != kStoredAs[j]) pose.rotations[indexOf(twin)] = mirrored(rotation);
  }
  pose.rootPosition = {0.0, table.heightMetres + kStraightening, 0.0};
  const Skeleton skeleton = gaitSkeleton();
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const Leg leg = gaitLeg(side);
    const JointPlacement ankle = placeJoint(skeleton, pose.view(), leg.ankle);
    const Heading outward = separateHeading(ankle.rotation).heading;
    const Vec3 under(ankle.position.x(), kFlatAnkleMetres, ankle.position.z());
    const Quat flat = outward.rotation() * axisRotation(Axis::kX, kFlatFootPitch);
    solveLeg(skeleton, leg, {under, flat}, 1.0, pose.rootPosition, pose.rotations);
  }
  return pose;
}

double gaitCadence(Gait gait, double speed, double turnRate) {
  const GaitTable& table = gaitTable(gait);
  const double u = speed - table.referenceSpeed;
  return table.cadence[0] + table.cadence[1] * u + table.cadence[2] * u * u +
         table.cadence[3] * turnRate * turnRate;
}

Angle gaitSlip(Gait gait, double turnRate, double turnAcceleration) {
  const GaitTable& table = gaitTable(gait);
  return Angle::radians(table.slip[0] * turnRate + table.slip[1] * turnAcceleration);
}

ContactPhases gaitContact(Gait gait, double speed) {
  const auto& knots = gaitTable(gait).contacts;
  if (speed <= knots.front().speedMetresPerSecond) return {knots.front().onPhase, knots.front().offPhase};
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    const double span = knots[k + 1].speedMetresPerSecond - knots[k].speedMetresPerSecond;
    const double share = span > 0.0 ? (speed - knots[k].speedMetresPerSecond) / span : 2.0;
    if (share <= 1.0)
      return {std::lerp(knots[k].onPhase, knots[k + 1].onPhase, share),
              std::lerp(knots[k].offPhase, knots[k + 1].offPhase, share)};
  }
  return {knots.back().onPhase, knots.back().offPhase};
}

Vec3 gaitHeel(Gait gait) {
  const auto& heel = gaitTable(gait).heelInFoot;
  return {heel[0], heel[1], heel[2]};
}

Pose mirrored(const Pose& pose) {
  Pose result = pose;
  result.rootPosition.x() = -pose.rootPosition.x();
  for (std::size_t j = 0; j < kGaitJointCount; ++j)
    result.rotations[indexOf(otherSide(static_cast<GaitJoint>(j)))] = mirrored(pose.rotations[j]);
  return result;
}

}  // namespace stridegraph
