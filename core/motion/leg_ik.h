#pragma once

#include <span>

#include "motion/kinematics.h"
#include "motion/skeleton.h"

namespace stridegraph {

/// A leg of any skeleton: the knee hangs on the hip and the ankle on the knee.
struct Leg {
  JointIndex hip;
  JointIndex knee;
  JointIndex ankle;
  /// The axis about which a positive turn bends the knee, in the hip joint's own axes. Only asked where the
  /// leg is so straight that its pose does not tell.
  Vec3 bendAxis = Vec3::UnitX();
};

/// Where an ankle should be, in the world.
struct AnkleTarget {
  Vec3 position;  ///< Metres.
  Quat rotation;
};

/// Length of the thigh and of the shin, metres.
struct LegLengths {
  double thigh;
  double shin;
  double whole() const { return thigh + shin; }
};
LegLengths legLengths(const Skeleton& skeleton, const Leg& leg);

/// Two-bone inverse kinematics in closed form: turns hip, knee and ankle of a pose (`rotations`, local, one
/// for each joint) so that the ankle comes to the target and takes its world rotation. The knee bends in the
/// plane that it bends in already, then the hip takes the shortest turn towards the target. The leg never
/// gets longer than `longestShare` (0..1) of its length; a target farther away is approached along the
/// straight line from the hip. Returns how far the ankle stays from the target, in metres: 0 within reach.
/// Continuous in target and pose as long as the target stays off the hip.
double solveLeg(const Skeleton& skeleton, const Leg& leg, const AnkleTarget& target, double longestShare,
                const Vec3& rootPosition, std::span<Quat> rotations);
/// The same where the hip's place in the world is known.
double solveLeg(const Skeleton& skeleton, const Leg& leg, const AnkleTarget& target, double longestShare,
                const JointPlacement& hip, std::span<Quat> rotations);

/// World rotation and place of one joint: forward kinematics along its ancestors only.
JointPlacement placeJoint(const Skeleton& skeleton, const PoseView& pose, JointIndex joint);

}  // namespace stridegraph
