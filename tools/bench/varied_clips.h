#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "motion/bvh_reader.h"

namespace stridegraph::bench {

/// The default gait clips over and over until there are `frames` frames, each repeat another take: its pace
/// lies up to 6 % beside the clip's, and every joint strays by up to 1.5 degrees, slowly. So takes of one
/// clip differ about as repeats of an actor do. The same clips for the same seed.
std::vector<BvhDocument> variedGaitClips(std::size_t frames, std::uint64_t seed);

}  // namespace stridegraph::bench
