#pragma once

#include <array>

#include "motion/gait_table.h"

namespace stridegraph::gait_fit {

/// What tables call the stored joints, in the order of StoredJoint.
inline constexpr std::array<const char*, kStoredJointCount> kJointNames = {
    "pelvis", "thorax", "head", "femur", "tibia", "foot", "humerus", "radius", "hand"};

}  // namespace stridegraph::gait_fit
