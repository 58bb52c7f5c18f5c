#pragma once

#include <cstdint>
#include <vector>

#include "math/typed_index.h"

namespace stridegraph {

/// A frame of a library, counted through all of its clips.
using FrameIndex = TypedIndex<struct FrameTag>;
using NodeIndex = TypedIndex<struct NodeTag>;
using EdgeIndex = TypedIndex<struct EdgeTag>;

enum class EdgeKind : std::uint8_t { kClipPiece, kTransition };

/// A way from one node to another. Playing it shows every frame after the `from` node up to and with the `to`
/// node, so that edges in a row never show a frame twice.
struct MotionEdge {
  NodeIndex from;
  NodeIndex to;
  EdgeKind kind = EdgeKind::kClipPiece;
  /// Frames shown, >= 1. A clip piece shows as many as its nodes are apart. A transition of length l shows
  /// l - 1: its first frame is the `from` node itself, its last is the `to` node.
  std::uint32_t frames = 1;
  /// For a transition, where its blend runs: sources from..from+sourceSpan in the one clip and
  /// to-targetSpan..to in the other (frames; both l - 1 where the regions are of equal length).
  std::uint32_t sourceSpan = 0;
  std::uint32_t targetSpan = 0;
  float distanceMetres = 0.0F;  ///< For a transition, mean distance along its region (eq. 5.2, in metres).
};

/// A directed graph whose nodes are frames and whose edges are pieces of clips and transitions
/// (thesis 3.2.4.3, 5.3.4). After pruning every node can be reached from every other.
struct MotionGraph {
  std::vector<FrameIndex> nodes;  ///< Ascending.
  std::vector<MotionEdge> edges;  ///< Sorted by (from, to, kind).
  /// edges[firstEdge[n] .. firstEdge[n + 1]) leave node n; nodes.size() + 1 entries.
  std::vector<std::uint32_t> firstEdge;

  std::size_t clipPieceCount() const;
  std::size_t transitionCount() const { return edges.size() - clipPieceCount(); }
};

/// What an edge plays, told by frames of the library alone, so that it needs no graph to be played.
struct MotionPiece {
  EdgeKind kind = EdgeKind::kClipPiece;
  FrameIndex from;
  FrameIndex to;
  std::uint32_t frames = 0;  ///< This and the following as in MotionEdge.
  std::uint32_t sourceSpan = 0;
  std::uint32_t targetSpan = 0;
  float distanceMetres = 0.0F;
};

MotionPiece pieceOf(const MotionGraph& graph, const MotionEdge& edge);
/// Frames from..to of one clip, from <= to.
MotionPiece clipPiece(FrameIndex from, FrameIndex to);

}  // namespace stridegraph
