#pragma once

#include <vector>

#include "graph/library.h"
#include "motion/motion_limits.h"

namespace stridegraph {

/// A joint that turns, or changes its turning, by more than this many times its limit looks driven.
inline constexpr double kDrivenRatio = 1.5;

/// What the joints of a library's clips do at most as they were captured: a mirrored arm is to move no faster
/// than that arm did.
MotionLimits capturedLimits(const MotionLibrary& library);

/// By how much each frame of a library drives a joint beyond kDrivenRatio times its limit: of the worst
/// joint, 0 for most frames. Rounded to 1/64, so that it is the same on every machine.
std::vector<float> frameStrains(const MotionLibrary& library, const MotionLimits& limits);

}  // namespace stridegraph
