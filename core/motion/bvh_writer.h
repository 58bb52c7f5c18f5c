#pragma once

#include <string>

#include "motion/bvh_layout.h"
#include "motion/clip.h"

namespace stridegraph {

/// The clip as BVH text with the names, channels, unit and axes of `layout`. Reading it back gives the same
/// motion within 1e-4 m and 0.01 degrees. Joints that stand still (BvhLayout::still) are
/// written around the skeleton. Its root gets all six channels, and a joint with fewer than three
/// rotation channels gets the missing ones where the clip turns it in ways that these cannot say. Euler
/// angles go on without jumps from frame to frame (bvhEulerTrack). Names are made such that a line can hold
/// them: UTF-8, "_" for braces and control characters, "joint" for none. Numbers are finite, at most 1e9 in
/// size. `layout` must have an entry for each joint of the
/// skeleton.
std::string writeBvh(const Skeleton& skeleton, const BvhLayout& layout, const Clip& clip);

}  // namespace stridegraph
