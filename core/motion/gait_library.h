#pragma once

#include <vector>

#include "motion/clip.h"

namespace stridegraph {

/// The default clips: synthesised walks and jogs of the body of gaitSkeleton() at 30 frames a second, so that
/// a library can be built with no captured data. Straight at several speeds, changes of speed, turns of 45,
/// 90, 135 and 180 degrees to both sides, tight (0.45 m) and wide (1.1 m), slalom, start, stop, standing,
/// turns on the spot, jogs, and bridges between walk and jog. Left and right are mirror images. What connects
/// clips lies 15 frames and more from their ends, since a transition cannot reach the rest. The same clips on
/// every call.
std::vector<Clip> defaultGaitClips();

/// Where the default clips come from, for a library's licence line.
inline constexpr char kGaitClipsLicense[] =
    "Synthesised from figures measured on the CMU Graphics Lab Motion Capture Database, subject 16; no "
    "captured frame. "
    "The data used in this project was obtained from mocap.cs.cmu.edu. The database was created with funding "
    "from "
    "NSF EIA-0196217.";

}  // namespace stridegraph
