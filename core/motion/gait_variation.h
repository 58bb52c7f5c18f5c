#pragma once

#include "motion/clip.h"
#include "motion/gait_track.h"

namespace stridegraph {

/// Gives a clip of the gait body what a mean over many strides lacks: arms that swing a little more in one
/// step than in the next, a trunk that does not come back to quite the same place, the jolt of each heel
/// strike that runs up the body and dies away within a few frames, and the fine unrest of trunk and arms.
/// Seeded by the request, scaled by its variation (0 changes nothing). Legs are left to whoever plants the
/// feet. A mirrored request gets the mirrored unrest. Frames of clip and track are the same.
void enliven(const GaitRequest& request, const GaitTrack& track, Clip& clip);

}  // namespace stridegraph
