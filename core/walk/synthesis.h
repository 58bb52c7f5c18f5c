#pragma once

#include <vector>

#include "graph/library.h"
#include "motion/clip.h"
#include "walk/motion_path.h"

namespace stridegraph {

/// Frames of a walk and where each comes from.
struct SynthesisedWalk {
  Clip clip;                               ///< In the room; frame 0 stands at the path's start.
  std::vector<FloorTransform> placements;  ///< One for each frame: placementsAlong() the path.
  std::vector<EdgeKind> frameKinds;        ///< One for each frame: captured, or blended in a transition.
  std::vector<ContactMask> contacts;       ///< One for each frame, bits as in MotionLibrary::contactJoints.
  std::vector<Vec2> accelerations;         ///< One for each frame: what bending adds over the floor, m/s2.
};

/// Placements (root on the floor, facing) of all frames that a path shows, in the room.
std::vector<FloorTransform> placementsAlong(const MotionLibrary& library, const MotionPath& path);

/// Turns a way through the graph into one clip: captured frames are moved over the floor and otherwise left
/// alone, transitions are blended (eq. 5.5 to 5.10).
SynthesisedWalk synthesise(const MotionLibrary& library, const MotionPath& path);

}  // namespace stridegraph
