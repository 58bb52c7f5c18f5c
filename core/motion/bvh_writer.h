#pragma once

#include <string>

#include "motion/bvh_layout.h"
#include "motion/clip.h"

namespace stridegraph {

/// The clip as BVH text with the names, channels, unit and axes of `layout`. Reading it back gives the same
/// motion within 1e-4 m and 0.01 degrees.
std::string writeBvh(const Skeleton& skeleton, const BvhLayout& layout, const Clip& clip);

}  // namespace stridegraph
