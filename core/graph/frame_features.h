#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "graph/row_products.h"
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
/// The products of single frames are shared by the windows along a diagonal. Numbers are 32 bit floats, in
/// panels (row_products.h) that are zero beyond the end, so that neighbouring columns are handled by the same
/// instruction and each sum runs in the same order on every machine.
class ClipFeatures {
 public:
  /// The path of the centre through a window: 4 directions beside the mean span 5 frames.
  static constexpr std::size_t kMotionPoints = 4;

  ClipFeatures(const Skeleton& skeleton, const FeatureBasis& basis, const Clip& clip);

  std::size_t frameCount() const { return frameCount_; }
  /// Windows that lie within the clip; window w is centred on frame w + kWindowReach.
  std::size_t windowCount() const;
  /// Frames, rounded up to whole panels.
  std::size_t paddedCount() const { return paddedCount_; }
  std::size_t jointCount() const { return jointCount_; }

  /// Weighted joints of single frames, with heights: a point for each joint. One panel more than needed.
  const PanelTerm* frames() const { return frames_.data(); }
  /// Path of the centre through each window: kMotionPoints points without heights.
  const PanelTerm* motion() const { return motion_.data(); }
  /// Each window's product with itself, to the last bit as a pair of equal windows is summed.
  const float* energies() const { return energies_.data(); }

 private:
  void addFrame(const FeatureBasis& basis, std::size_t frame, std::span<const Vec3> positions);
  void addMotion(std::size_t window);
  void addEnergies(std::size_t firstWindow);

  std::size_t frameCount_;
  std::size_t paddedCount_;
  std::size_t jointCount_;
  std::vector<Vec2> centres_;
  std::vector<PanelTerm> frames_, motion_;
  std::vector<float> energies_;
};

}  // namespace stridegraph
