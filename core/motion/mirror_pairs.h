#pragma once

#include <vector>

#include "motion/skeleton.h"

namespace stridegraph {

/// For each joint its partner on the other side, by name; empty when the names tell no pair, or tell pairs
/// that do not fit the tree.
std::vector<JointIndex> pairJointsByName(const Skeleton& skeleton);

/// The same by the rest pose (all rotations zero): partners lie where the reflection in the plane through the
/// root with this normal puts them, within 5 % of the body's extent. Empty when that does not give pairs
/// that fit the tree.
std::vector<JointIndex> pairJointsByRestPose(const Skeleton& skeleton, const Vec3& planeNormal);

}  // namespace stridegraph
