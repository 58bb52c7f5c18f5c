#pragma once

#include <span>

#include "motion/clip.h"
#include "path/floor_plan.h"

namespace stridegraph {

/// Length of the root's way over the floor, metres.
double rootPathLength(const Clip& walk);

/// Smallest distance of the root disc's rim to anything that stands, over all frames; negative when it
/// touches.
double smallestClearance(const FloorPlan& plan, const Clip& walk);

/// Mean horizontal speed of the feet while they are down, cm/s: weighted (2 - 2^(h/H)) for a foot h < H = 2.5
/// cm above that joint's own floor level, over two frames running (Zhang et al. 2018, section 6). `feet` are
/// joints of the skeleton.
double footSkate(const Skeleton& skeleton, const Clip& walk, std::span<const JointIndex> feet);

}  // namespace stridegraph
