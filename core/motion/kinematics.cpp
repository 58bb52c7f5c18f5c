#include "motion/kinematics.h"

#include <algorithm>

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

JointChains::JointChains(const Skeleton& skeleton, std::span<const JointIndex> joints) {
  std::vector<bool> wanted(skeleton.size(), false);
  wanted[0] = true;
  for (const JointIndex joint : joints) wanted[joint.value] = true;
  for (std::size_t j = skeleton.size(); j-- > 1;)
    if (wanted[j]) wanted[skeleton.joints[j].parent->value] = true;
  for (std::size_t j = 0; j < skeleton.size(); ++j) {
    if (!wanted[j]) continue;
    const Joint& joint = skeleton.joints[j];
    const std::size_t parentSlot = joint.parent ? slotOf(*joint.parent) : 0;
    links_.push_back({JointIndex(j), parentSlot, joint.offset, joint.isEndSite});
  }
}

std::size_t JointChains::slotOf(JointIndex joint) const {
  const auto at = std::lower_bound(links_.begin(), links_.end(), joint,
                                   [](const Link& link, JointIndex wanted) { return link.joint < wanted; });
  STRIDEGRAPH_CHECK(at != links_.end() && at->joint == joint);
  return static_cast<std::size_t>(at - links_.begin());
}

void JointChains::place(const PoseView& pose, std::span<JointPlacement> placements) const {
  STRIDEGRAPH_CHECK(placements.size() == links_.size());
  placements[0] = {pose.rotations[0], pose.rootPosition};
  for (std::size_t i = 1; i < links_.size(); ++i) {
    const Link& link = links_[i];
    const JointPlacement& parent = placements[link.parentSlot];
    placements[i].position = parent.position + parent.rotation * link.offset;
    placements[i].rotation =
        link.isEndSite ? parent.rotation : parent.rotation * pose.rotations[link.joint.value];
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
