#pragma once

#include <span>
#include <string>
#include <vector>

#include "math/types.h"
#include "motion/skeleton.h"

namespace stridegraph {

/// One configuration m(t) = (p_r, q_r, q_1..q_n), eq. 3.1, borrowed from a clip.
struct PoseView {
  const Vec3& rootPosition;  ///< World, metres.
  std::span<const Quat>
      rotations;  ///< One for each joint of the skeleton, relative to its parent; [0] is q_r.
};

/// A configuration of its own.
struct Pose {
  Vec3 rootPosition = Vec3::Zero();
  std::vector<Quat> rotations;

  PoseView view() const { return {rootPosition, rotations}; }
};

/// Frames of one skeleton at one rate. Frame f holds rotations [f * jointCount, (f + 1) * jointCount).
struct Clip {
  std::string name;
  double framesPerSecond = 30.0;
  std::size_t jointCount = 0;
  std::vector<Vec3> rootPositions;  ///< World, metres, y up; one for each frame.
  std::vector<Quat> rotations;      ///< frameCount x jointCount, unit length.

  std::size_t frameCount() const { return rootPositions.size(); }
  PoseView pose(std::size_t frame) const;
  std::span<Quat> rotationsOf(std::size_t frame);
  std::span<const Quat> rotationsOf(std::size_t frame) const;
  /// Appends a frame; the pose must have jointCount rotations.
  void append(const PoseView& pose);
};

/// Frames first..last of a clip, both ends included; first <= last < frameCount. Borrows the clip.
struct ClipSpan {
  const Clip* clip = nullptr;
  std::size_t first = 0;
  std::size_t last = 0;
};

/// All frames of a clip that has some.
ClipSpan wholeOf(const Clip& clip);

}  // namespace stridegraph
