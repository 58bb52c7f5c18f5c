#pragma once

#include "motion/clip.h"
#include "motion/gait_track.h"

namespace stridegraph {

/// Shifts the root over the foot that carries where somebody is about to step out of a stand, comes to one,
/// or steps on the spot: it begins before the foot is lifted (Winter 1995 describes this for gait
/// initiation). The feet are planted afterwards.
void shiftWeight(const GaitTrack& track, Clip& clip);

}  // namespace stridegraph
