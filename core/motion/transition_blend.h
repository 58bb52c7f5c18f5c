#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "math/floor_transform.h"
#include "motion/clip.h"

namespace stridegraph {

/// How the share of the target grows from 0 to 1 through a blend.
enum class BlendEase {
  kSmooth,  ///< 3 u^2 - 2 u^3: continuous speed at both ends (Kovar, Gleicher and Pighin 2002, section 3.2).
  kLinear,  ///< u, as printed in eq. 5.5 and 5.10.
};

/// How the floor positions and headings of two roots are joined.
enum class RootBlend {
  kDifferential,  ///< Local displacement and turn of each step are blended, then summed (eq. 5.5 to 5.9).
  /// Positions and headings themselves, the target placed so that its span begins where the source's does.
  /// It makes the body slide sideways (fig. 5.7); for comparison.
  kPlain,
};

struct TransitionBlendParams {
  BlendEase ease = BlendEase::kSmooth;
  RootBlend root = RootBlend::kDifferential;
};

/// A transition to be blended. Spans have two frames at least; those of other than frames - 1 steps are
/// played faster or slower, as blendProgress() says, and sampled between their frames. Both clips have the
/// same skeleton.
struct TransitionBlend {
  ClipSpan source;
  ClipSpan target;
  std::size_t frames = 13;  ///< Frames of the blend, both ends included, >= 2.
  TransitionBlendParams params = {};
};

/// The poses of the blend in the source's world: frame 0 is the source's first frame, the last is the
/// target's last frame as to joints, tilt and height, placed on the floor where the blended steps lead.
/// Joints and the root's tilt are slerped (eq. 5.10), its height is interpolated linearly.
Clip blendPoses(const TransitionBlend& blend);

/// A blend whose root has been laid out and whose poses are made one by one.
class BlendedPoses {
 public:
  explicit BlendedPoses(const TransitionBlend& blend);

  /// blendTrack() of it.
  const std::vector<FloorTransform>& track() const { return track_; }
  /// Writes the pose of a frame as in blendPoses(); `rotations` has one for each joint.
  void pose(std::size_t frame, Vec3& rootPosition, std::span<Quat> rotations) const;

 private:
  TransitionBlend blend_;
  std::vector<FloorTransform> track_;
};

/// Only where the root goes: floor point and heading at each frame, in the source's world. Exactly the
/// placements of blendPoses(), by additions, products and square roots alone: the same bits on every machine.
std::vector<FloorTransform> blendTrack(const TransitionBlend& blend);

/// How far through its spans (in steps) a blend of `steps` steps is after `step` of them, 0..1: both clips
/// are at that share of their spans, so that like poses meet (section 3.2.4.2). It begins at the source's own
/// pace and ends at the target's (a cubic of Hermite, kept monotone as by Fritsch and Carlson 1980), where
/// the constant delta_k of eq. 5.7 would change pace with a jolt at both ends. step / steps for spans of
/// `steps`.
double blendProgress(std::size_t sourceSpan, std::size_t targetSpan, std::size_t steps, std::size_t step);

/// Floor point and heading of a root: the character's c(t) of eq. 5.4.
FloorTransform rootPlacement(const PoseView& pose);

}  // namespace stridegraph
