#include "walk/piece_motion.h"

#include <algorithm>

namespace stridegraph {
namespace {

TransitionBlend blendOf(const MotionLibrary& library, const MotionPiece& piece) {
  const std::size_t from = piece.from.value;
  const std::size_t to = piece.to.value;
  return {{&library.frames, from, from + piece.sourceSpan},
          {&library.frames, to - piece.targetSpan, to},
          std::size_t{piece.frames} + 1};
}

}  // namespace

std::size_t capturedFrameAt(const MotionPiece& piece, std::size_t position) {
  const std::size_t from = piece.from.value;
  if (piece.kind == EdgeKind::kClipPiece) return from + position;
  const double progress = blendProgress(piece.sourceSpan, piece.targetSpan, piece.frames, position);
  const auto framesInto = [&](std::uint32_t span) {
    return static_cast<std::size_t>(progress * static_cast<double>(span) + 0.5);
  };
  return 2 * position < piece.frames ? from + framesInto(piece.sourceSpan)
                                     : piece.to.value - piece.targetSpan + framesInto(piece.targetSpan);
}

PieceMotion::PieceMotion(const MotionLibrary& library, const MotionPiece& piece)
    : library_(library), from_(piece.from.value) {
  if (piece.kind == EdgeKind::kTransition) blended_.emplace(blendOf(library, piece));
}

FloorTransform PieceMotion::placement(std::size_t position) const {
  if (!blended_) return library_.placementAt(FrameIndex(from_ + position));
  const FloorTransform& root = blended_->track()[position];
  return {root.translation, root.heading - library_.facingOffset};
}

void PieceMotion::pose(std::size_t position, Vec3& rootPosition, std::span<Quat> rotations) const {
  if (blended_) {
    blended_->pose(position, rootPosition, rotations);
    return;
  }
  const PoseView captured = library_.frames.pose(from_ + position);
  rootPosition = captured.rootPosition;
  std::copy(captured.rotations.begin(), captured.rotations.end(), rotations.begin());
}

std::vector<FloorTransform> pieceTrack(const MotionLibrary& library, const MotionPiece& piece) {
  const PieceMotion motion(library, piece);
  const FloorTransform fromWorld = motion.placement(0).inverse();
  std::vector<FloorTransform> track(std::size_t{piece.frames} + 1);
  for (std::size_t p = 1; p < track.size(); ++p) track[p] = fromWorld * motion.placement(p);
  return track;
}

}  // namespace stridegraph
