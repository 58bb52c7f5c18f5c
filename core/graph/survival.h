#pragma once

#include <span>
#include <vector>

#include "graph/graph_building.h"
#include "graph/library_builder.h"

namespace stridegraph {

/// What became of each clip of a library, and why not all of it is in the graph: pruning left `pruned`, which
/// may have been thinned to what the library holds.
std::vector<ClipFate> clipFates(const MotionLibrary& library, const MotionGraph& pruned,
                                std::span<const FrameTransition> transitions);

}  // namespace stridegraph
