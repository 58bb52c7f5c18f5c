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

/// World positions of every joint at one frame.
std::vector<Vec3> jointPositions(const Skeleton& skeleton, const PoseView& pose);

}  // namespace stridegraph
