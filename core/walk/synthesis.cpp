#include "walk/synthesis.h"

#include "base/check.h"
#include "motion/transition_blend.h"
#include "walk/piece_motion.h"

namespace stridegraph {
namespace {

/// Appends a frame of `poses`, brought into the room.
void appendPlaced(const Clip& poses, std::size_t frame, const FloorTransform& roomFromPiece, Clip& walk) {
  walk.append(poses.pose(frame));
  const std::size_t last = walk.frameCount() - 1;
  walk.rootPositions[last] = roomFromPiece.apply(poses.rootPositions[frame]);
  Quat& root = walk.rotationsOf(last)[0];
  root = (roomFromPiece.heading.rotation() * root).normalized();
}

/// Contacts at a position on a piece: of the captured frame there, and in a blend of the clip that weighs
/// more.
ContactMask contactsAt(const MotionLibrary& library, const MotionPiece& piece, std::uint32_t position) {
  const std::uint32_t from = piece.from.value;
  const std::uint32_t to = piece.to.value;
  if (piece.kind == EdgeKind::kClipPiece) return library.contacts[from + position];
  const double progress = blendProgress(piece.sourceSpan, piece.targetSpan, piece.frames, position);
  const auto framesInto = [&](std::uint32_t span) {
    return static_cast<std::uint32_t>(progress * static_cast<double>(span) + 0.5);
  };
  return 2 * position < piece.frames ? library.contacts[from + framesInto(piece.sourceSpan)]
                                     : library.contacts[to - piece.targetSpan + framesInto(piece.targetSpan)];
}

}  // namespace

std::vector<FloorTransform> placementsAlong(const MotionLibrary& library, const MotionPath& path) {
  std::vector<FloorTransform> placements = {path.start};
  for (const WalkStep& step : path.steps) {
    const std::vector<FloorTransform> track = pieceTrack(library, step.piece);
    const FloorTransform atPieceStart = placements.back() * track[step.begin].inverse();
    for (std::uint32_t p = step.begin + 1; p <= step.end; ++p) placements.push_back(atPieceStart * track[p]);
  }
  return placements;
}

SynthesisedWalk synthesise(const MotionLibrary& library, const MotionPath& path) {
  STRIDEGRAPH_CHECK(!path.steps.empty());
  SynthesisedWalk walk;
  walk.clip.framesPerSecond = library.frames.framesPerSecond;
  walk.clip.jointCount = library.skeleton.size();
  walk.placements = placementsAlong(library, path);
  for (const WalkStep& step : path.steps) {
    const MotionPiece& piece = step.piece;
    const Clip poses = piecePoses(library, piece);
    // The frame at `begin` was shown by the step before, except at the very beginning.
    const bool begins = walk.clip.frameCount() == 0;
    const std::size_t shown = begins ? 0 : walk.clip.frameCount() - 1;
    const std::uint32_t first = begins ? step.begin : step.begin + 1;
    const FloorTransform roomFromPiece = placePoses(library, poses, step.begin, walk.placements[shown]);
    for (std::uint32_t p = first; p <= step.end; ++p) {
      appendPlaced(poses, p, roomFromPiece, walk.clip);
      const bool blended = piece.kind == EdgeKind::kTransition && p > 0 && p < piece.frames;
      walk.frameKinds.push_back(blended ? EdgeKind::kTransition : EdgeKind::kClipPiece);
      walk.contacts.push_back(contactsAt(library, piece, p));
    }
  }
  return walk;
}

}  // namespace stridegraph
