#pragma once

#include "motion/clip.h"

namespace stridegraph::testing {

/// A leg that can be checked by hand: hip 1 m above the floor, knee 0.5 m below it, ankle 0.5 m below the
/// knee, and a foot that ends 0.2 m in front.
inline Skeleton oneLeg() {
  Skeleton skeleton;
  skeleton.joints = {{"hip", {}, {0, 0, 0}},
                     {"knee", JointIndex(std::size_t{0}), {0, -0.5, 0}},
                     {"ankle", JointIndex(std::size_t{1}), {0, -0.5, 0}},
                     {"ankle#end", JointIndex(std::size_t{2}), {0, 0, 0.2}, true}};
  return skeleton;
}

/// A pose of `skeleton` with the root at `rootPosition` and no rotation anywhere.
inline Pose restPose(const Skeleton& skeleton, const Vec3& rootPosition) {
  return {rootPosition, std::vector<Quat>(skeleton.size(), Quat::Identity())};
}

}  // namespace stridegraph::testing
