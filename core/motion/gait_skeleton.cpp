#include "motion/gait_skeleton.h"

namespace stridegraph {
namespace {

JointIndex jointIndex(GaitJoint joint) {
  return JointIndex(indexOf(joint));
}

bool between(GaitJoint joint, GaitJoint first, GaitJoint last) {
  return indexOf(joint) >= indexOf(first) && indexOf(joint) <= indexOf(last);
}

/// Appends the leg or the arm of one side; `side` is +1 on the left (+x) and -1 on the right.
void appendLeg(std::vector<Joint>& joints, const char* prefix, double side) {
  const std::string p = prefix;
  const std::size_t first = joints.size();
  joints.push_back({p + "femur", jointIndex(GaitJoint::kPelvis), {side * 0.11446, 0, 0}});
  joints.push_back({p + "tibia", JointIndex(first), {0, -0.420304, 0}});
  joints.push_back({p + "foot", JointIndex(first + 1), {0, -0.399302, 0}});
  joints.push_back({p + "toes", JointIndex(first + 2), {0, 0, 0.117758}});
  joints.push_back({p + "toes#end", JointIndex(first + 3), {0, 0, 0.05}, true});
}

void appendArm(std::vector<Joint>& joints, const char* prefix, double side) {
  const std::string p = prefix;
  const std::size_t first = joints.size();
  joints.push_back({p + "clavicle", jointIndex(GaitJoint::kThorax), {0, 0.39863, 0}});
  joints.push_back({p + "humerus", JointIndex(first), {side * 0.173806, 0.049583, 0}});
  joints.push_back({p + "radius", JointIndex(first + 1), {0, -0.275613, 0}});
  joints.push_back({p + "hand", JointIndex(first + 2), {0, -0.26933, 0}});
  joints.push_back({p + "hand#end", JointIndex(first + 3), {0, -0.05, 0}, true});
}

}  // namespace

GaitJoint otherSide(GaitJoint joint) {
  const auto shifted = [joint](std::ptrdiff_t by) {
    return static_cast<GaitJoint>(static_cast<std::ptrdiff_t>(indexOf(joint)) + by);
  };
  if (between(joint, GaitJoint::kLeftFemur, GaitJoint::kLeftToesEnd)) return shifted(5);
  if (between(joint, GaitJoint::kRightFemur, GaitJoint::kRightToesEnd)) return shifted(-5);
  if (between(joint, GaitJoint::kLeftClavicle, GaitJoint::kLeftHandEnd)) return shifted(5);
  if (between(joint, GaitJoint::kRightClavicle, GaitJoint::kRightHandEnd)) return shifted(-5);
  return joint;
}

Skeleton gaitSkeleton() {
  Skeleton skeleton;
  std::vector<Joint>& joints = skeleton.joints;
  joints.push_back({"pelvis", {}, Vec3::Zero()});
  appendLeg(joints, "l", 1.0);
  appendLeg(joints, "r", -1.0);
  joints.push_back({"thorax", jointIndex(GaitJoint::kPelvis), {0, 0.112556, -0.05}});
  joints.push_back({"head", jointIndex(GaitJoint::kThorax), {0, 0.437993, 0}});
  joints.push_back({"head#end", jointIndex(GaitJoint::kHead), {0, 0.05, 0}, true});
  appendArm(joints, "l", 1.0);
  appendArm(joints, "r", -1.0);
  return skeleton;
}

BvhLayout gaitBvhLayout() {
  using enum BvhChannel;
  BvhLayout layout;
  const Skeleton skeleton = gaitSkeleton();
  layout.endSiteNames.resize(skeleton.size());
  for (const Joint& joint : skeleton.joints) {
    std::vector<BvhChannel> channels;
    if (!joint.parent) channels = {kXPosition, kYPosition, kZPosition};
    if (!joint.isEndSite) channels.insert(channels.end(), {kZRotation, kXRotation, kYRotation});
    layout.channels.push_back(std::move(channels));
  }
  layout.unitsPerMetre = 100.0;
  layout.up = UpAxis::kY;
  return layout;
}

Leg gaitLeg(Side side) {
  const bool left = side == Side::kLeft;
  return {jointIndex(left ? GaitJoint::kLeftFemur : GaitJoint::kRightFemur),
          jointIndex(left ? GaitJoint::kLeftTibia : GaitJoint::kRightTibia),
          jointIndex(left ? GaitJoint::kLeftFoot : GaitJoint::kRightFoot), Vec3::UnitX()};
}

}  // namespace stridegraph
