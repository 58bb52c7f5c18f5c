#pragma once

#include <vector>

#include "graph/library.h"
#include "math/floor_transform.h"

namespace stridegraph {

/// Where the body is while a piece plays, relative to where it is at the piece's `from` frame: placements for
/// positions 0..frames (frames + 1 of them; the first is the identity).
std::vector<FloorTransform> pieceTrack(const MotionLibrary& library, const MotionPiece& piece);

/// The poses of a piece at positions 0..frames. Their roots are placed as in the library for a clip piece,
/// and as in the source clip for a transition: placePoses() tells what brings them into the room.
Clip piecePoses(const MotionLibrary& library, const MotionPiece& piece);

/// The floor transform that brings piecePoses() to where its frame at `position` stands at `placement`.
FloorTransform placePoses(const MotionLibrary& library, const Clip& poses, std::size_t position,
                          const FloorTransform& placement);

}  // namespace stridegraph
