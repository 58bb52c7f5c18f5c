#pragma once

#include <array>
#include <span>

#include "base/result.h"
#include "motion/clip.h"
#include "motion/gait_table.h"

namespace stridegraph::gait_fit {

/// Which joints of any skeleton do what those of the gait's table do. Middle joints are the same on both
/// sides.
struct BodyRoles {
  std::array<JointIndex, kStoredJointCount> left;
  std::array<JointIndex, kStoredJointCount> right;
};

/// Finds them without regard to names beyond telling pairs (see findMirrorMap): legs are the pair of limbs
/// that reach lowest, arms the pair that hangs highest; thigh and shin, upper arm and forearm are a limb's
/// two longest bones in a row; left is what lies left of the way the body goes. Fails with kSkeletonMismatch
/// and what is missing. Clips have frames.
Result<BodyRoles> findBodyRoles(const Skeleton& skeleton, std::span<const Clip> clips);

/// Unit floor direction in which the root goes at a frame, over a fifth of a second; zero where it is slower
/// than 0.3 m/s.
Vec2 travelAt(const Clip& clip, std::size_t frame);

}  // namespace stridegraph::gait_fit
