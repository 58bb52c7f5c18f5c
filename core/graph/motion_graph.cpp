#include "graph/motion_graph.h"

#include <algorithm>

namespace stridegraph {

std::size_t MotionGraph::clipPieceCount() const {
  return static_cast<std::size_t>(std::count_if(
      edges.begin(), edges.end(), [](const MotionEdge& edge) { return edge.kind == EdgeKind::kClipPiece; }));
}

}  // namespace stridegraph
