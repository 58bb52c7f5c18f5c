#pragma once

#include <vector>

#include "motion/clip.h"

namespace stridegraph {

/// The default clips: synthesised walks and jogs of the body of gaitSkeleton() at 30 frames a second, so that
/// a library can be built with no captured data. Straight at several speeds, changes of speed, turns of 45,
/// 90, 135 and 180 degrees to both sides, tight (0.45 m) and wide (1.1 m), slalom, start, stop, standing,
/// turns on the spot, starts into a turn, jogs from 2.3 to 3.0 m/s with turns, and bridges between walk and
/// jog.
///  Left and right are mirror images. What connects
/// clips lies 15 frames and more from their ends, since a transition cannot reach the rest. The same clips on
/// every call.
std::vector<Clip> defaultGaitClips();

/// Two jogs like those that the METU thesis built its graph of (section 5.3.4): a straight one of 46 frames
/// and a zig-zag of 105 frames with one turn to the right and one to the left, of 40 degrees each. Not part
/// of the default library, which has longer jogs; without variation, so that so little motion still connects.
std::vector<Clip> thesisGaitPair();

/// Where the default clips come from, for a library's licence line.
inline constexpr char kGaitClipsLicense[] =
    "Synthesised from figures measured on the CMU Graphics Lab Motion Capture Database, subject 16; no "
    "captured frame. "
    "The data used in this project was obtained from mocap.cs.cmu.edu. The database was created with funding "
    "from "
    "NSF EIA-0196217.";

}  // namespace stridegraph
