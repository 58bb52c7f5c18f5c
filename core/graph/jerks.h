#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graph/graph_building.h"
#include "graph/library.h"
#include "motion/motion_limits.h"

namespace stridegraph {

struct JerkParams {
  /// A joint that turns or changes its turning by more than this many times its limit (MotionLimits) may have
  /// been jerked, > 1: walks are to stay below.
  double ratio = 1.6;
  /// It was if it turns this many times faster than two to four frames before and after, > 1: captured limbs
  /// get up to speed over several frames.
  double factor = 1.5;
};

/// A joint that slips for a frame, too little for a Glitch but more than it ever does else.
struct Jerk {
  FrameIndex frame;  ///< The slip lies between this frame and the next.
  JointIndex joint;
  Angle turn;
};

/// The clips of a library, as frames first..last of library.frames; those without frames are left out.
std::vector<ClipSpan> clipSpans(const MotionLibrary& library);

/// The jerks of one joint against its limit over all clips, by frame; none of the root.
std::vector<Jerk> findJerks(const MotionLibrary& library, JointIndex joint, const JerkParams& params = {});

/// Those of all joints, as farthestByFrame() leaves them.
std::vector<Jerk> findJerks(const MotionLibrary& library);

/// By frame, and for each frame only the joint that turns farthest.
std::vector<Jerk> farthestByFrame(std::vector<Jerk> jerks);

/// How many frames each stretch has within which nothing is jerked: clips are divided at the jerks
/// (ascending), so that buildGraph() lets no piece of a clip play across one.
std::vector<std::uint32_t> steadyFrameCounts(const MotionLibrary& library, std::span<const Jerk> jerks);

/// Whether a jerk lies between two of the frames first..last.
bool playsAcross(std::span<const Jerk> jerks, FrameIndex first, FrameIndex last);

/// Whether a transition blends frames from both sides of a jerk.
bool blendsAcross(std::span<const Jerk> jerks, const FrameTransition& transition);

}  // namespace stridegraph
