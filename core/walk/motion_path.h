#pragma once

#include <cstdint>
#include <vector>

#include "graph/motion_graph.h"
#include "math/floor_transform.h"

namespace stridegraph {

/// A stretch of a piece of the library. A piece of n frames has positions 0 (its `from` frame) to n (its `to`
/// frame).
struct WalkStep {
  MotionPiece piece;
  std::uint32_t begin = 0;  ///< Position that the walk has when the step begins; not shown again.
  std::uint32_t end = 0;    ///< Position after the step, >= begin.
  Angle turnPerMetre = {};  ///< Added to the captured way (bentStep).
};

/// A way through the graph, laid out on the floor: what a motion search finds and synthesis turns into
/// frames. Each step begins where the one before it ended.
struct MotionPath {
  FloorTransform start;         ///< Placement (root on the floor, facing) at the beginning of the first step.
  std::vector<WalkStep> steps;  ///< Never empty.
};

}  // namespace stridegraph
