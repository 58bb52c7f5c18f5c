#pragma once

#include <cstdint>
#include <vector>

#include "motion/clip.h"

namespace stridegraph {

/// The clip as binary glTF 2.0: a node for each joint, one animation, and a simple body of bones skinned to
/// them, so that any viewer shows somebody walking.
std::vector<std::uint8_t> writeGlb(const Skeleton& skeleton, const Clip& clip);

}  // namespace stridegraph
