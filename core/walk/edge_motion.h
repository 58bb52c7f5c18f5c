#pragma once

#include <vector>

#include "graph/library.h"
#include "math/floor_transform.h"

namespace stridegraph {

/// Where the body is while an edge plays, relative to where it is at the edge's `from` node: placements for
/// positions 0..frames (frames + 1 of them; the first is the identity).
std::vector<FloorTransform> edgeTrack(const MotionLibrary& library, const MotionEdge& edge);

/// The poses of an edge at positions 0..frames. Their roots are placed as in the library for a clip piece,
/// and as in the source clip for a transition: `worldFromEdge` of placeEdge() brings them into the room.
Clip edgePoses(const MotionLibrary& library, const MotionEdge& edge);

/// The floor transform that brings edgePoses() to where its `from` node stands at `placement`.
FloorTransform placeEdge(const MotionLibrary& library, const MotionEdge& edge,
                         const FloorTransform& placement);

}  // namespace stridegraph
