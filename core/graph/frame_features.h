#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "motion/clip.h"

namespace stridegraph {

/// What all clips of one comparison share: which joints count, how much, and around which heights. Of the
/// clips only the first that has frames matters, and of that only the one in its middle: clips that are
/// appended leave it as it is.
struct FeatureBasis {
  std::vector<JointIndex> joints;     ///< Those of weight > 0.
  std::vector<double> weights;        ///< For each of them; sum to 1 over a window.
  std::vector<double> heightsMetres;  ///< Taken off, so that products keep digits.
};
FeatureBasis featureBasis(const Skeleton& skeleton, std::span<const Clip> clips);

/// A clip, prepared so that distances (eq. 5.2) of all pairs of windows come from products. With floor points
/// u relative to their frame's weighted centre c, and c relative to its mean over the window, the sums of
/// Kovar, Gleicher and Pighin 2002 (section 3.1) fall apart into
///   along  = sum over the window of (u . u') + (c . c'),  across = the same of (u x u'),
///   distance^2 = energy + energy' - 2 (sqrt(along^2 + across^2) + sum of height products).
/// The products of single frames are shared by the windows along a diagonal. Numbers are 32 bit floats,
/// stored term by term (all frames of a term in a row, `stride` apart), so that neighbouring columns are
/// handled by the same instruction and each sum runs in the same order on every machine.
class ClipFeatures {
 public:
  /// Columns of a row are padded by this many zeros at least, so that blocks may run over the end.
  static constexpr std::size_t kPadding = 24;
  /// The path of the centre through a window: 4 directions beside the mean span 5 frames.
  static constexpr std::size_t kMotionTerms = 8;

  ClipFeatures(const Skeleton& skeleton, const FeatureBasis& basis, const Clip& clip);

  std::size_t frameCount() const { return frameCount_; }
  /// Windows that lie within the clip; window w is centred on frame w + kWindowReach.
  std::size_t windowCount() const;
  std::size_t stride() const { return stride_; }
  std::size_t jointCount() const { return jointCount_; }

  /// Weighted floor points: x of every joint, then z of every joint; 2 jointCount() terms of single frames.
  const float* planar() const { return planar_.data(); }
  /// Weighted heights: jointCount() terms of single frames.
  const float* heights() const { return heights_.data(); }
  /// Path of the centre: kMotionTerms / 2 in x, then as many in z; terms of windows.
  const float* motion() const { return motion_.data(); }
  /// Each window's product with itself.
  const double* energies() const { return energies_.data(); }

 private:
  void addFrame(const FeatureBasis& basis, std::size_t frame, std::span<const Vec3> positions);
  void addMotion(std::size_t window);
  void addEnergy(std::size_t window);

  std::size_t frameCount_;
  std::size_t stride_;
  std::size_t jointCount_;
  std::vector<Vec2> centres_;
  std::vector<float> planar_, heights_, motion_;
  std::vector<double> energies_;
};

}  // namespace stridegraph
