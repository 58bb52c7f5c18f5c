#pragma once

#include "motion/clip.h"
#include "motion/gait_track.h"

namespace stridegraph {

/// Lets the head look where the walk will go: it turns towards the heading that the body will have in a third
/// of a second, the trunk a little with it, and comes back as the turn ends (Grasso, Glasauer, Takei and
/// Berthoz 1996 and Hollands, Patla and Vickers 2002 saw the head lead by 0.2 to 0.4 s). Of the trunk's
/// pitching and rolling the neck takes most out again, so that the eyes stay level. Frames of clip and track
/// are the same; all but thorax and head stay.
void leadWithTheHead(const GaitTrack& track, Clip& clip);

}  // namespace stridegraph
