#pragma once

#include <span>

#include "motion/clip.h"
#include "motion/gait_skeleton.h"
#include "motion/gait_track.h"

namespace stridegraph {

/// Pins the feet of a clip of the gait body to the floor. Each stance gets one footprint; while it lasts the
/// foot rolls over it, about the heel when the toes point up and over ball and toe end when they point
/// down: the toes bend as the heel rises. What that moves the ankle (place and yaw) fades through the swing
/// by a cubic Hermite curve with the slopes of both ends. A stance ends early where the leg would get too
/// long; what is still missing lowers the root a little. Frames of the clip and of the track are the same.
void plantFeet(const GaitTrack& track, Clip& clip);

}  // namespace stridegraph
