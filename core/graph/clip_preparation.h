#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "graph/library.h"
#include "motion/clip.h"

namespace stridegraph {

/// The clip at the library's rate. Rates within 0.5 % of it are taken as it, frame for frame, so that a
/// file's rounded frame time does not blur what was captured.
Clip atLibraryRate(const Clip& clip, double framesPerSecond);

/// How many frames atLibraryRate() gives.
std::size_t frameCountAtLibraryRate(const Clip& clip, double framesPerSecond);

/// How far a clip has to be lifted to the library's floor: nothing where it is within a centimetre of it.
/// Metres.
double floorLiftMetres(double libraryFloorMetres, double clipFloorMetres);

/// What is said of a clip that was lifted by so much.
Warning liftWarning(const std::string& clipName, double liftMetres);

/// Rounds every number to the 32 bit float that files hold, and end sites to no rotation, so that a library
/// in memory and the same one from a file are equal.
void roundToFloats(const Skeleton& skeleton, Clip& clip);

}  // namespace stridegraph
