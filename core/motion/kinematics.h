#pragma once

#include <span>
#include <vector>

#include "motion/clip.h"

namespace stridegraph {

/// A joint's place in the world: worldFromJoint.
struct JointPlacement {
  Quat rotation;
  Vec3 position;  ///< Metres.
};

/// Forward kinematics: where every joint of the skeleton lies in the world. `placements` has one entry for
/// each joint and is overwritten.
void placeJoints(const Skeleton& skeleton, const PoseView& pose, std::span<JointPlacement> placements);

/// Forward kinematics of some joints and what they hang on, and of nothing else.
class JointChains {
 public:
  /// Joints in any order; asking twice is harmless.
  JointChains(const Skeleton& skeleton, std::span<const JointIndex> joints);

  /// How many joints are placed.
  std::size_t size() const { return links_.size(); }
  /// Where placeJoints() puts a joint that was asked for, or one that it hangs on.
  std::size_t slotOf(JointIndex joint) const;
  /// Places the joints as placeJoints() of the whole skeleton does, bit for bit; `placements` has size().
  void place(const PoseView& pose, std::span<JointPlacement> placements) const;

 private:
  struct Link {
    JointIndex joint;
    std::size_t parentSlot = 0;
    Vec3 offset;
    bool isEndSite = false;
  };
  std::vector<Link> links_;  ///< Parents before children; the root first.
};

/// World positions of every joint at one frame.
std::vector<Vec3> jointPositions(const Skeleton& skeleton, const PoseView& pose);

}  // namespace stridegraph
