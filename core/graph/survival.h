#pragma once

#include <span>
#include <vector>

#include "graph/build_report.h"
#include "graph/graph_building.h"
#include "graph/library.h"

namespace stridegraph {

/// What became of each clip of a library, and why not all of it is in the graph: pruning left `pruned`, which
/// may have been thinned to what the library holds.
std::vector<ClipFate> clipFates(const MotionLibrary& library, const MotionGraph& pruned,
                                std::span<const FrameTransition> transitions);

/// First and last frame, within a clip, of what a graph plays of it without a gap.
struct PlayedRun {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};
/// For each clip of a library, ascending.
std::vector<std::vector<PlayedRun>> playedRuns(const MotionLibrary& library, const MotionGraph& graph);

/// How many frames of a library a graph plays.
std::size_t playedFrames(const MotionLibrary& library, const MotionGraph& graph);

}  // namespace stridegraph
