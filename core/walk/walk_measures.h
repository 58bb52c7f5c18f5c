#pragma once

#include <span>
#include <vector>

#include "math/floor_transform.h"
#include "motion/clip.h"
#include "path/floor_plan.h"

namespace stridegraph {

/// Length of the root's way over the floor, metres.
double rootPathLength(const Clip& walk);
/// The same of placements, frame by frame.
double wayLength(std::span<const FloorTransform> way);

/// Smallest distance of the root disc's rim to anything that stands, over all frames; negative when it
/// touches.
double smallestClearance(const FloorPlan& plan, const Clip& walk);

/// Where each foot joint goes: metres, world, for each of the feet one place for each frame.
using FootPaths = std::vector<std::vector<Vec3>>;
FootPaths footPaths(const Skeleton& skeleton, const ClipSpan& span, std::span<const JointIndex> feet);

/// Each foot joint's level on the floor: what it stays above in all but 2 % of the frames. Metres.
std::vector<double> footFloors(const FootPaths& paths);

/// Mean horizontal speed of the feet while they are down, cm/s: weighted (2 - 2^(h/H)) for a foot h < H = 2.5
/// cm above that joint's own footFloors(), over two frames running (Zhang et al. 2018, section 6).
double footSkate(const FootPaths& paths, double framesPerSecond);

/// How far the lowest foot joint sinks below these floors, one for each of the feet; 0 when none does.
/// Metres.
double footPenetration(const FootPaths& paths, std::span<const double> floorsMetres);

}  // namespace stridegraph
