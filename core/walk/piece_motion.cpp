#include "walk/piece_motion.h"

#include "motion/transition_blend.h"

namespace stridegraph {
namespace {

TransitionBlend blendOf(const MotionLibrary& library, const MotionPiece& piece) {
  const std::size_t from = piece.from.value;
  const std::size_t to = piece.to.value;
  return {{&library.frames, from, from + piece.sourceSpan},
          {&library.frames, to - piece.targetSpan, to},
          std::size_t{piece.frames} + 1};
}

/// Placements at positions 0..frames in the world of piecePoses().
std::vector<FloorTransform> placementsOn(const MotionLibrary& library, const MotionPiece& piece) {
  std::vector<FloorTransform> placements;
  if (piece.kind == EdgeKind::kTransition) {
    placements = blendTrack(blendOf(library, piece));
    for (FloorTransform& placement : placements) placement.heading = placement.heading - library.facingOffset;
    return placements;
  }
  const std::size_t from = piece.from.value;
  for (std::size_t p = 0; p <= piece.frames; ++p)
    placements.push_back(library.placementAt(FrameIndex(from + p)));
  return placements;
}

}  // namespace

std::vector<FloorTransform> pieceTrack(const MotionLibrary& library, const MotionPiece& piece) {
  std::vector<FloorTransform> track = placementsOn(library, piece);
  const FloorTransform fromWorld = track.front().inverse();
  track.front() = {};
  for (std::size_t p = 1; p < track.size(); ++p) track[p] = fromWorld * track[p];
  return track;
}

Clip piecePoses(const MotionLibrary& library, const MotionPiece& piece) {
  if (piece.kind == EdgeKind::kTransition) return blendPoses(blendOf(library, piece));
  Clip poses;
  poses.framesPerSecond = library.frames.framesPerSecond;
  poses.jointCount = library.frames.jointCount;
  const std::size_t from = piece.from.value;
  for (std::size_t p = 0; p <= piece.frames; ++p) poses.append(library.frames.pose(from + p));
  return poses;
}

FloorTransform placePoses(const MotionLibrary& library, const Clip& poses, std::size_t position,
                          const FloorTransform& placement) {
  FloorTransform inPoses = rootPlacement(poses.pose(position));
  inPoses.heading = inPoses.heading - library.facingOffset;
  return placement * inPoses.inverse();
}

}  // namespace stridegraph
