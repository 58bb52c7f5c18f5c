#include "graph/motion_graph.h"

#include <algorithm>

namespace stridegraph {

std::size_t MotionGraph::clipPieceCount() const {
  return static_cast<std::size_t>(std::count_if(
      edges.begin(), edges.end(), [](const MotionEdge& edge) { return edge.kind == EdgeKind::kClipPiece; }));
}

MotionPiece pieceOf(const MotionGraph& graph, const MotionEdge& edge) {
  return {
      edge.kind,       graph.nodes[edge.from.value], graph.nodes[edge.to.value], edge.frames, edge.sourceSpan,
      edge.targetSpan, edge.distanceMetres};
}

MotionPiece clipPiece(FrameIndex from, FrameIndex to) {
  return {EdgeKind::kClipPiece, from, to, to.value - from.value, 0, 0, 0.0F};
}

}  // namespace stridegraph
