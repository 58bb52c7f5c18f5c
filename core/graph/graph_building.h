#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graph/motion_graph.h"

namespace stridegraph {

/// A blend from frame to frame of a library, not yet an edge between nodes.
struct FrameTransition {
  FrameIndex from;
  FrameIndex to;
  std::uint32_t sourceSpan = 0;  ///< Steps in the source and
  std::uint32_t targetSpan = 0;  ///< in the target.
  std::uint32_t frames = 0;      ///< Shown: as MotionEdge::frames.
  float distanceMetres = 0.0F;
};

/// The graph of clips that lie one after the other and of transitions between their frames (section 5.3.4).
/// Nodes are the frames where something starts or ends: both ends of every clip and of every transition.
/// Pieces of clips join neighbouring nodes of a clip, so that there are as many as nodes less clips. Clips of
/// no frames have no nodes, of one frame one.
MotionGraph buildGraph(std::span<const std::uint32_t> clipFrameCounts,
                       std::span<const FrameTransition> transitions);

/// The nodes for which `keep` is true, renumbered, and the edges between them.
MotionGraph partOf(const MotionGraph& graph, const std::vector<bool>& keep);

/// The largest strongly connected part (Tarjan 1972, without recursion): within it no walk ever dies. Largest
/// by nodes; of equal ones the one with the earliest node. Empty when no part has an edge.
MotionGraph largestStronglyConnectedPart(const MotionGraph& graph);

/// Dissolves nodes with exactly one way in and one way out, both pieces of a clip: nothing is decided there.
/// The pieces become one.
MotionGraph withoutPassThroughNodes(const MotionGraph& graph);

/// Sorts edges by (from, to, kind, spans, distance) and fills firstEdge.
void indexEdges(MotionGraph& graph);

}  // namespace stridegraph
