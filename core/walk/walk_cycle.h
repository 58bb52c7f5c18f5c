#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "graph/library.h"
#include "walk/walk_feet.h"

namespace stridegraph {

/// Two steps of a captured walk straight on, one with each foot, for what the upper body does meanwhile. A
/// step lasts from the middle of one time in which both feet are down to the middle of the next.
struct WalkCycle {
  std::size_t firstFoot = 0;  ///< The foot that swings in the first step.
  double begin = 0.0;         ///< Library frames, where the first step begins,
  double middle = 0.0;        ///< the second one,
  double end = 0.0;           ///< and where that ends.
  double before = 0.0;        ///< Where the step before the first one began.
};

/// Joints that no leg hangs on or consists of: all but the root, the legs and what lies between them.
std::vector<JointIndex> upperJoints(const Skeleton& skeleton, const std::array<WalkFoot, 2>& feet);

/// The steadiest cycle of a library: of those at a walking speed that hardly turn, the one whose upper body
/// ends most nearly as it began. Nothing where there is none.
std::optional<WalkCycle> steadiestCycle(const MotionLibrary& library, const std::array<WalkFoot, 2>& feet,
                                        const std::vector<JointIndex>& joints);

/// How a joint is turned in a share 0..1 of a step with one foot. The end of the second step leads over to
/// the beginning of the first without a jump.
Quat rotationInCycle(const MotionLibrary& library, const WalkCycle& cycle, JointIndex joint, std::size_t foot,
                     double share);

}  // namespace stridegraph
