#pragma once

#include <vector>

#include "motion/clip.h"

namespace stridegraph {

/// The default clips: synthesised walks and jogs of the body of gaitSkeleton() at 30 frames a second, so that
/// a library can be built with no captured data. Straight at several speeds, changes of speed, tight turns
/// (0.44 to 0.48 m) of 45, 90, 135 and 180 degrees, begun every quarter of the gait cycle so that a walker
/// can turn where a corner is, a wide one (1.1 m), slalom, start, stop, standing, turns on the spot, starts
/// that turn on the spot first, jogs from 2.3 to 3.0 m/s with a turn, and bridges between walk and jog.
/// Straight jogs are short and have one turn on purpose: where jogging is the cheapest way to cover a metre,
/// walks through rooms jog and go wide around corners.
/// Left and right are mirror images. What connects clips lies 15 frames and more from their ends, since a
/// transition cannot reach the rest. The same clips on every call.
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
