#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "motion/clip.h"

namespace stridegraph {

/// How fast one joint turns against its parent, step by step.
struct TurnRates {
  std::vector<double> speeds;         ///< From frame f to f + 1, rad/s: frames - 1 of them.
  std::vector<double> accelerations;  ///< About frame f + 1, rad/s^2: frames - 2 of them.
};

/// Rates of a joint along a span: lengths of rotation vectors between neighbouring frames, and of their
/// changes.
TurnRates turnRates(const ClipSpan& span, JointIndex joint);
std::vector<TurnRates> turnRates(std::span<const ClipSpan> clips, JointIndex joint);

/// What the joints of captured clips do at most: for each joint but the root the 99.9th percentile of its
/// rates, so that one glitch does not excuse others, and never less than what a still joint's noise reaches.
struct MotionLimits {
  std::vector<double> speeds;         ///< rad/s, one for each joint; that of the root is infinite.
  std::vector<double> accelerations;  ///< rad/s^2
};

/// Limits of one joint from its rates in some clips; joint by joint, so that long work can be sliced.
struct JointLimit {
  double speed;         ///< rad/s
  double acceleration;  ///< rad/s^2
};
JointLimit jointLimit(std::span<const TurnRates> clips);

MotionLimits motionLimits(std::span<const ClipSpan> clips);

/// How far a motion goes beyond what is usual, and where.
struct WorstRatio {
  double ratio = 0.0;     ///< Of the limit; 0 without any motion.
  std::size_t frame = 0;  ///< For a speed the second of two frames, for an acceleration the middle one.
  JointIndex joint;
};
struct WorstRatios {
  WorstRatio speed, acceleration;
};
WorstRatios worstRatios(const MotionLimits& limits, const Clip& clip);

/// Calls visit(frame of the clip, ratio) wherever a joint goes beyond `least` (> 0) times its limit within a
/// span.
void visitRatios(const MotionLimits& limits, const ClipSpan& span, double least,
                 const std::function<void(std::size_t, double)>& visit);

}  // namespace stridegraph
