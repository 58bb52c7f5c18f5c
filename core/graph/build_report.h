#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/error.h"

namespace stridegraph {

/// What became of a clip.
struct ClipFate {
  std::string name;
  std::size_t frames = 0;
  std::size_t transitions = 0;      ///< Found between it and any clip before pruning.
  std::size_t survivingFrames = 0;  ///< Frames on edges of the library's graph.
  std::string reason;               ///< Why not all of it survives; empty when it does.
};

/// What building found, kept and dropped, and why.
struct BuildReport {
  std::size_t framePairs =
      0;  ///< Compared so far; pairs that an appended library knew already not among them.
  std::size_t nodesBeforePruning = 0, clipPiecesBeforePruning = 0, transitionsBeforePruning = 0;
  std::size_t nodes = 0, clipPieces = 0, transitions = 0;
  /// Transitions after pruning and before thinning: more than `transitions` where the library's limit
  /// (LibraryParams::mostTransitions) left some out.
  std::size_t transitionsBeforeThinning = 0;
  double survivingShare = 0.0;  ///< Of all frames.
  std::vector<ClipFate> clips;
  Warnings warnings;
};

}  // namespace stridegraph
