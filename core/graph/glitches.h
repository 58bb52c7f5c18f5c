#pragma once

#include <cstddef>
#include <vector>

#include "math/angle.h"
#include "motion/clip.h"

namespace stridegraph {

struct GlitchParams {
  /// A joint that turns farther from one frame to the next may be a glitch, > 0 (40 degrees: 1200 degrees a
  /// second at 30 Hz, twice what walking and running joints reach).
  Angle leastTurn = Angle::degrees(40);
  /// It is one if the turn is this many times what the joint turns nearby, > 1 (feet pushing off reach 3.6).
  double factor = 4.0;
};

/// A jump of a joint against its own trend: a fault of capture, not motion.
struct Glitch {
  std::size_t frame = 0;  ///< The jump lies between this frame and the next.
  JointIndex joint;
  Angle turn;
};

/// The jumps of a clip, by frame, the farthest joint of each: turns beyond leastTurn that are `factor` times
/// the median of the three turns before and the three after.
std::vector<Glitch> findGlitches(const Clip& clip, const GlitchParams& params = {});

/// The clip, cut between the frames of every glitch, so that nothing plays across one. Single frames between
/// two glitches are left out. The pieces after the first are named "NAME from frame N".
std::vector<Clip> cutAtGlitches(const Clip& clip, const std::vector<Glitch>& glitches);

}  // namespace stridegraph
