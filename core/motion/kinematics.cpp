#include "motion/kinematics.h"

#include "base/check.h"

namespace stridegraph {

void placeJoints(const Skeleton& skeleton, const PoseView& pose, std::span<JointPlacement> placements) {
  STRIDEGRAPH_CHECK(pose.rotations.size() == skeleton.size() && placements.size() == skeleton.size());
  for (std::size_t j = 0; j < skeleton.size(); ++j) {
    const Joint& joint = skeleton.joints[j];
    if (!joint.parent) {
      placements[j] = {pose.rotations[j], pose.rootPosition};
      continue;
    }
    const JointPlacement& parent = placements[joint.parent->value];
    placements[j] = {parent.rotation * pose.rotations[j], parent.position + parent.rotation * joint.offset};
  }
}

std::vector<Vec3> jointPositions(const Skeleton& skeleton, const PoseView& pose) {
  std::vector<JointPlacement> placements(skeleton.size());
  placeJoints(skeleton, pose, placements);
  std::vector<Vec3> positions;
  positions.reserve(placements.size());
  for (const JointPlacement& placement : placements) positions.push_back(placement.position);
  return positions;
}

}  // namespace stridegraph
