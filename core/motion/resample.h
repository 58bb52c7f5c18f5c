#pragma once

#include <cstddef>

#include "motion/clip.h"

namespace stridegraph {

/// The clip at another rate, which must be > 0: rotations by slerp (eq. 5.10), the root's path linearly
/// between its frames. Begins at the clip's first moment and lasts as long, to within a frame of the new
/// rate: nothing is made up behind the last frame. Moments that are frames of the clip stay as captured.
/// Neighbouring frames' quaternions never differ by the sign alone.
Clip resample(const Clip& clip, double framesPerSecond);

/// How many frames resample() makes of a clip of `frameCount` frames at one rate at another, both > 0.
std::size_t resampledFrameCount(std::size_t frameCount, double fromFramesPerSecond, double toFramesPerSecond);

/// Gives each joint's quaternions the sign that lies nearer to the frame before, from the second frame on.
void makeSignsContinuous(Clip& clip);

}  // namespace stridegraph
