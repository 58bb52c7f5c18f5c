#pragma once

#include <span>
#include <vector>

#include "graph/graph_building.h"
#include "graph/library.h"

namespace stridegraph {

/// The transitions that regions offer, two for each: from the one piece to the other and back. A transition
/// shows as many frames as its spans have steps on average.
std::vector<FrameTransition> transitionsOf(std::span<const AlikeRegion> regions);

}  // namespace stridegraph
