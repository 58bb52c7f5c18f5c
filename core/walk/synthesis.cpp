#include "walk/synthesis.h"

#include <span>

#include "base/check.h"
#include "motion/transition_blend.h"
#include "walk/bent_step.h"
#include "walk/piece_motion.h"

namespace stridegraph {
namespace {

std::size_t frameCountOf(const MotionPath& path) {
  std::size_t count = 1;
  for (const WalkStep& step : path.steps) count += step.end - step.begin;
  return count;
}

/// Calls visit(step, motion of its piece, roomFromPiece, position, placement) for every frame that a path
/// shows: the first frame of each step but the very first was shown by the step before.
template <typename Visit>
void visitFrames(const MotionLibrary& library, const MotionPath& path, const Visit& visit) {
  FloorTransform shown = path.start;
  bool begins = true;
  for (const WalkStep& step : path.steps) {
    const PieceMotion motion(library, step.piece);
    FloorTransform captured = motion.placement(step.begin);
    FloorTransform roomFromPiece = shown * captured.inverse();
    if (begins) visit(step, motion, roomFromPiece, step.begin, shown);
    begins = false;
    for (std::uint32_t p = step.begin + 1; p <= step.end; ++p) {
      const FloorTransform next = motion.placement(p);
      if (step.turnPerMetre != Angle{})
        roomFromPiece = shown * bentStep(captured.inverse() * next, step.turnPerMetre) * next.inverse();
      shown = roomFromPiece * next;
      captured = next;
      visit(step, motion, roomFromPiece, p, shown);
    }
  }
}

/// The acceleration over the floor, m/s2, that an added turn means for a body that moves by this in a frame.
Vec2 accelerationOf(const Vec2& moved, Angle turnPerMetre, double framesPerSecond) {
  const Vec2 towardsMiddle(moved.y(), -moved.x());
  return turnPerMetre.radians() * moved.norm() * framesPerSecond * framesPerSecond * towardsMiddle;
}

}  // namespace

std::vector<FloorTransform> placementsAlong(const MotionLibrary& library, const MotionPath& path) {
  std::vector<FloorTransform> placements;
  placements.reserve(frameCountOf(path));
  visitFrames(library, path,
              [&](const WalkStep&, const PieceMotion&, const FloorTransform&, std::uint32_t,
                  const FloorTransform& placement) { placements.push_back(placement); });
  return placements;
}

SynthesisedWalk synthesise(const MotionLibrary& library, const MotionPath& path) {
  STRIDEGRAPH_CHECK(!path.steps.empty());
  const std::size_t frameCount = frameCountOf(path);
  SynthesisedWalk walk;
  walk.clip.framesPerSecond = library.frames.framesPerSecond;
  walk.clip.jointCount = library.skeleton.size();
  walk.clip.rootPositions.resize(frameCount);
  walk.clip.rotations.resize(frameCount * walk.clip.jointCount);
  walk.placements.reserve(frameCount);
  walk.frameKinds.reserve(frameCount);
  walk.contacts.reserve(frameCount);
  walk.accelerations.reserve(frameCount);
  visitFrames(
      library, path,
      [&](const WalkStep& step, const PieceMotion& motion, const FloorTransform& roomFromPiece,
          std::uint32_t position, const FloorTransform& placement) {
        const MotionPiece& piece = step.piece;
        const std::size_t frame = walk.placements.size();
        Vec3& root = walk.clip.rootPositions[frame];
        const std::span<Quat> rotations = walk.clip.rotationsOf(frame);
        motion.pose(position, root, rotations);
        root = roomFromPiece.apply(root);
        rotations[0] = (roomFromPiece.heading.rotation() * rotations[0]).normalized();
        const Vec2 moved =
            frame == 0 ? Vec2::Zero() : Vec2(placement.translation - walk.placements.back().translation);
        walk.accelerations.push_back(accelerationOf(moved, step.turnPerMetre, walk.clip.framesPerSecond));
        walk.placements.push_back(placement);
        const bool blended = piece.kind == EdgeKind::kTransition && position > 0 && position < piece.frames;
        walk.frameKinds.push_back(blended ? EdgeKind::kTransition : EdgeKind::kClipPiece);
        walk.contacts.push_back(library.contacts[capturedFrameAt(piece, position)]);
      });
  return walk;
}

}  // namespace stridegraph
