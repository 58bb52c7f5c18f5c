#include "motion/leg_ik.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace stridegraph {
namespace {

/// Weight of the bend axis against the bend that the pose shows (the sine of its angle): it decides below
/// about one degree and cannot be felt above ten.
constexpr double kBendAxisWeight = 0.02;

/// The unit axis, square to the thigh, about which the knee bends.
Vec3 bendDirection(const Vec3& thigh, const Vec3& shin, const Vec3& hint) {
  const Vec3 square = hint - thigh * thigh.dot(hint);
  const Vec3 axis = thigh.cross(shin) + kBendAxisWeight * square;
  const double length = axis.norm();
  return length > 1e-12 ? Vec3(axis / length) : thigh.unitOrthogonal();
}

/// Cosine of the angle between thigh and shin, 1 when straight, that puts the ankle at `distance` from the
/// hip.
double kneeCosine(const LegLengths& lengths, double distance) {
  const double cosine = (distance * distance - lengths.thigh * lengths.thigh - lengths.shin * lengths.shin) /
                        (2.0 * lengths.thigh * lengths.shin);
  return std::clamp(cosine, -1.0, 1.0);
}

}  // namespace

JointPlacement placeJoint(const Skeleton& skeleton, const PoseView& pose, JointIndex joint) {
  const Joint& self = skeleton.joints[joint.value];
  if (!self.parent) return {pose.rotations[joint.value], pose.rootPosition};
  const JointPlacement parent = placeJoint(skeleton, pose, *self.parent);
  return {parent.rotation * pose.rotations[joint.value], parent.position + parent.rotation * self.offset};
}

LegLengths legLengths(const Skeleton& skeleton, const Leg& leg) {
  return {skeleton.joints[leg.knee.value].offset.norm(), skeleton.joints[leg.ankle.value].offset.norm()};
}

double solveLeg(const Skeleton& skeleton, const Leg& leg, const AnkleTarget& target, double longestShare,
                const Vec3& rootPosition, std::span<Quat> rotations) {
  const JointPlacement hip = placeJoint(skeleton, {rootPosition, rotations}, leg.hip);
  return solveLeg(skeleton, leg, target, longestShare, hip, rotations);
}

double solveLeg(const Skeleton& skeleton, const Leg& leg, const AnkleTarget& target, double longestShare,
                const JointPlacement& hip, std::span<Quat> rotations) {
  STRIDEGRAPH_CHECK(skeleton.joints[leg.knee.value].parent == leg.hip);
  STRIDEGRAPH_CHECK(skeleton.joints[leg.ankle.value].parent == leg.knee);
  const LegLengths lengths = legLengths(skeleton, leg);
  const Quat kneeBefore = hip.rotation * rotations[leg.knee.value];
  const Vec3 thigh = (hip.rotation * skeleton.joints[leg.knee.value].offset) / lengths.thigh;
  const Vec3 shin = (kneeBefore * skeleton.joints[leg.ankle.value].offset) / lengths.shin;

  const Vec3 wanted = target.position - hip.position;
  const double wantedDistance = wanted.norm();
  const double distance = std::clamp(wantedDistance, std::abs(lengths.thigh - lengths.shin) + 1e-6,
                                     longestShare * lengths.whole());
  const Vec3 axis = bendDirection(thigh, shin, hip.rotation * leg.bendAxis);
  const double cosine = kneeCosine(lengths, distance);
  const Vec3 bentShin = cosine * thigh + std::sqrt(1.0 - cosine * cosine) * axis.cross(thigh);

  const Quat kneeTurn = Quat::FromTwoVectors(shin, bentShin);
  const Vec3 reached = lengths.thigh * thigh + lengths.shin * bentShin;
  const Quat hipTurn = wantedDistance > 1e-9 ? Quat::FromTwoVectors(reached, wanted) : Quat::Identity();

  const Quat hipRotation = hipTurn * hip.rotation;
  const Quat kneeRotation = hipTurn * kneeTurn * kneeBefore;
  const Quat hipParent = hip.rotation * rotations[leg.hip.value].conjugate();
  rotations[leg.hip.value] = (hipParent.conjugate() * hipRotation).normalized();
  rotations[leg.knee.value] = (hipRotation.conjugate() * kneeRotation).normalized();
  rotations[leg.ankle.value] = (kneeRotation.conjugate() * target.rotation).normalized();
  return std::abs(wantedDistance - distance);
}

}  // namespace stridegraph
