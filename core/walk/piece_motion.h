#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "graph/library.h"
#include "math/floor_transform.h"
#include "motion/transition_blend.h"

namespace stridegraph {

/// Where the body is while a piece plays, relative to where it is at the piece's `from` frame: placements for
/// positions 0..frames (frames + 1 of them; the first is the identity).
std::vector<FloorTransform> pieceTrack(const MotionLibrary& library, const MotionPiece& piece);

/// The library's frame that a piece shows at a position; in a blend, of the clip that weighs more.
std::size_t capturedFrameAt(const MotionPiece& piece, std::size_t position);

/// A piece read position by position, 0..frames. Bodies stand as in the library on a clip piece, and as in
/// the world of the source clip on a transition. Borrows the library.
class PieceMotion {
 public:
  PieceMotion(const MotionLibrary& library, const MotionPiece& piece);

  /// Where the body stands and looks.
  FloorTransform placement(std::size_t position) const;
  /// Writes a pose; `rotations` has one for each joint.
  void pose(std::size_t position, Vec3& rootPosition, std::span<Quat> rotations) const;

 private:
  const MotionLibrary& library_;
  std::size_t from_;                     ///< Frame of position 0.
  std::optional<BlendedPoses> blended_;  ///< Of a transition.
};

}  // namespace stridegraph
