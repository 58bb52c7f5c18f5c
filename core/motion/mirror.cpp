#include "motion/mirror.h"

#include "base/check.h"
#include "motion/kinematics.h"
#include "motion/resample.h"

namespace stridegraph {

Vec3 mirrored(const Vec3& vector) {
  return {-vector.x(), vector.y(), vector.z()};
}

Quat mirrored(const Quat& rotation) {
  return {rotation.w(), rotation.x(), -rotation.y(), -rotation.z()};
}

// World rotations are mirrored, not local ones: these mean the same on both sides only where the rest axes of
// both sides mirror each other.
Clip mirrored(const Skeleton& skeleton, const MirrorMap& map, const Clip& clip) {
  STRIDEGRAPH_CHECK(map.partner.size() == skeleton.size() && map.correction.size() == skeleton.size());
  Clip result;
  result.name = clip.name + " (mirrored)";
  result.framesPerSecond = clip.framesPerSecond;
  result.jointCount = clip.jointCount;
  std::vector<JointPlacement> placements(skeleton.size());
  std::vector<Quat> worldFromJoint(skeleton.size());
  Pose pose;
  pose.rotations.resize(skeleton.size());
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    placeJoints(skeleton, clip.pose(f), placements);
    pose.rootPosition = mirrored(clip.rootPositions[f]);
    for (std::size_t j = 0; j < skeleton.size(); ++j) {
      const Joint& joint = skeleton.joints[j];
      worldFromJoint[j] = mirrored(placements[map.partner[j].value].rotation) * map.correction[j];
      if (joint.isEndSite) {
        pose.rotations[j] = Quat::Identity();
      } else if (joint.parent) {
        pose.rotations[j] =
            (worldFromJoint[joint.parent->value].conjugate() * worldFromJoint[j]).normalized();
      } else {
        pose.rotations[j] = worldFromJoint[j].normalized();
      }
    }
    result.append(pose.view());
  }
  makeSignsContinuous(result);
  return result;
}

}  // namespace stridegraph
