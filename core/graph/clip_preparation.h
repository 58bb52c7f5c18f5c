#pragma once

#include <span>
#include <vector>

#include "base/error.h"
#include "graph/library.h"
#include "motion/clip.h"

namespace stridegraph {

/// The clip at the library's rate. Rates within 0.5 % of it are taken as it, frame for frame, so that a
/// file's rounded frame time does not blur what was captured.
Clip atLibraryRate(const Clip& clip, double framesPerSecond);

/// Brings the floors of clips to one level where they differ: clips whose feet keep to a level more than a
/// centimetre off the middle one are raised or lowered to it. One warning for each.
Warnings levelFloors(const Skeleton& skeleton, std::span<Clip> clips);

/// Rounds every number to the 32 bit float that files hold, and end sites to no rotation, so that a library
/// in memory and the same one from a file are equal.
void roundToFloats(const Skeleton& skeleton, Clip& clip);

}  // namespace stridegraph
