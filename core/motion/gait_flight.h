#pragma once

#include "motion/clip.h"
#include "motion/gait_track.h"

namespace stridegraph {

/// Gives the jog its flight: while no foot is down the root falls freely (9.81 m/s^2), and it bounces as high
/// as the captured jogs did, which a mean over many strides flattens. What that changes is spread over the
/// stances between as smoothly as possible: the least squares of root accelerations and of what is changed.
/// Walking frames stay. Frames of clip and track are the same; the feet are planted afterwards.
void fallFreely(const GaitTrack& track, Clip& clip);

}  // namespace stridegraph
