#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "motion/clip.h"

namespace stridegraph {

/// The clip as binary glTF 2.0: a node for each joint, one animation, and a simple body of bones skinned to
/// them, so that any viewer shows somebody walking.
std::vector<std::uint8_t> writeGlb(const Skeleton& skeleton, const Clip& clip);

/// Clips of several bodies that move at the same time, one or more, in one file. Where they are several, each
/// has its joints below a node of its own ("walker_1", "walker_2", ...) and its body beside it
/// ("walker_1_body"); one animation moves them all, since viewers play one at a time. Who is done first stays
/// as it is.
std::vector<std::uint8_t> writeGlb(const Skeleton& skeleton, std::span<const Clip* const> clips);

}  // namespace stridegraph
