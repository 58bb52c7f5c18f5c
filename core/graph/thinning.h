#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "graph/library.h"

namespace stridegraph {

struct ThinningParams {
  std::size_t mostTransitions = 15'000;
  std::uint32_t stretchFrames = 120;  ///< About, > 0: clips are cut into equal stretches.
};

/// Of a graph with more transitions than that, a part with no more, in which whatever the clips show is there
/// as often as everything else: a large library shows the same motion many times, and for every pair of times
/// it holds transitions, so that their number grows with the square of its length, though nothing new is to
/// be had.
///
/// Stretches of the clips are chosen one after the other, each time the one that the chosen ones represent
/// least. A frame is represented by as many transitions as join it, within their blends, with a chosen
/// stretch, and a stretch as well as the tenth of its frames that is represented least: that a turn begins
/// and ends with a few usual steps does not make it usual. Of equal ones the earlier is chosen.
///
/// `graph` is strongly connected, and so is the part; it may be empty. A smaller graph comes back as it is.
MotionGraph thinnedGraph(const MotionGraph& graph, std::span<const LibraryClip> clips,
                         const ThinningParams& params);

}  // namespace stridegraph
