#pragma once

#include <vector>

#include "motion/clip.h"
#include "motion/skeleton.h"

namespace stridegraph {

/// A round cone between two points that hang on joints: one part of the body.
struct Bone {
  JointIndex fromJoint;
  JointIndex toJoint;
  Vec3 fromOffset = Vec3::Zero();  ///< In the joint's own axes, metres.
  Vec3 toOffset = Vec3::Zero();
  double fromRadius = 0.05;  ///< Metres.
  double toRadius = 0.05;
};

/// A bone where it is at one moment.
struct Capsule {
  Vec3 from = Vec3::Zero();
  Vec3 to = Vec3::Zero();
  double fromRadius = 0.0;
  double toRadius = 0.0;
};

/// Clothes a skeleton in round cones. Which chain is a leg, an arm or the head is seen from `standing`, a
/// pose on its feet: legs are the chains that end lowest, the head is the chain that ends highest, arms are
/// what else is long. So it works for any names and any number of spine joints. Radii are shares of the
/// height.
std::vector<Bone> bonesFor(const Skeleton& skeleton, const PoseView& standing);

std::vector<Capsule> placeBones(const std::vector<Bone>& bones, const Skeleton& skeleton,
                                const PoseView& pose);

}  // namespace stridegraph
