#pragma once

#include <span>

#include "math/floor_transform.h"
#include "motion/clip.h"

namespace stridegraph {

struct FacingParams {
  /// Slower frames say nothing about where the body looks, >= 0 (0.3 m/s: a fifth of a walk).
  double minimumSpeedMetresPerSecond = 0.3;
};

/// How far root headings lie from the direction of travel: the circular mean over every step of the clips
/// that is faster than the minimum. A body's facing is its root heading less this. Zero when nothing moves.
Heading facingOffset(std::span<const Clip> clips, const FacingParams& params = {});

}  // namespace stridegraph
