#pragma once

#include <span>
#include <vector>

#include "walk/walk_feet.h"

namespace stridegraph {

/// How a body leans over its feet in one frame. The root stays over its place on the floor, so the feet go
/// out to the other side: half as far as those of a leaning pole, the trunk does the rest.
struct Lean {
  Quat turn = Quat::Identity();  ///< Of the root, and of the hips with it, about the root's place.
  Vec3 feetMove = Vec3::Zero();  ///< Whole feet go there, as flat as they are, metres.
  double rootSinks = 0.0;        ///< So that the legs need not get longer for it, metres.

  bool isUpright() const { return feetMove == Vec3::Zero(); }
};

/// Leans, frame by frame, that balance accelerations over the floor (m/s2) which the captured poses do not
/// know: towards their smooth mean over a step to either side, by the angle whose tangent is its share
/// of gravity. `roots`: metres. Upright where nothing is accelerated near.
std::vector<Lean> balancingLeans(std::span<const Vec2> accelerations, std::span<const Vec3> roots,
                                 double framesPerSecond);

/// Takes hips and foot to where they are once the body leans over its roots (metres).
void leanOver(std::span<const Lean> leans, std::span<const Vec3> roots, FootTrack& track);

}  // namespace stridegraph
