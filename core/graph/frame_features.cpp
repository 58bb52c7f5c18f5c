#include "graph/frame_features.h"

#include <array>
#include <cmath>

#include "graph/pose_distance.h"
#include "graph/window_sums.h"
#include "motion/kinematics.h"

namespace stridegraph {
namespace {

/// Orthogonal polynomials over five points, without the constant: each row sums to 0 and is orthogonal to the
/// others, so that products of the projections equal products of the centred paths.
constexpr std::array<std::array<double, kWindowFrames>, 4> kPolynomials = {
    {{-2, -1, 0, 1, 2}, {2, -1, -2, -1, 2}, {-1, 2, 0, -2, 1}, {1, -4, 6, -4, 1}}};
constexpr std::array<double, 4> kSquaredLengths = {10, 14, 10, 70};
constexpr auto kFloorTerms = static_cast<std::size_t>(PointTerms::kFloor);
constexpr auto kSpaceTerms = static_cast<std::size_t>(PointTerms::kSpace);
static_assert(ClipFeatures::kMotionPoints == kPolynomials.size());

std::size_t wholePanels(std::size_t columns) {
  return (columns + kPanelColumns - 1) / kPanelColumns;
}

/// Where one column of a panel keeps its points: term t of point p is at [(p * terms + t) * kPanelColumns].
template <typename Panels>
auto* columnOf(Panels& panels, std::size_t panelTerms, std::size_t column) {
  return panels[column / kPanelColumns * panelTerms].columns.data() + column % kPanelColumns;
}

/// Products of a column with itself, term after term as multiplyRows() sums those of pairs.
struct SelfProducts {
  float along = 0.0F;
  float height = 0.0F;
};
SelfProducts selfProducts(const float* terms, PointTerms kind, std::size_t points) {
  SelfProducts sums;
  for (std::size_t p = 0; p < points; ++p, terms += static_cast<std::size_t>(kind) * kPanelColumns) {
    sums.along += terms[0] * terms[0];
    sums.along += terms[kPanelColumns] * terms[kPanelColumns];
    if (kind == PointTerms::kSpace) sums.height += terms[2 * kPanelColumns] * terms[2 * kPanelColumns];
  }
  return sums;
}

}  // namespace

FeatureBasis featureBasis(const Skeleton& skeleton, std::span<const Clip> clips) {
  const std::vector<double> weights = distanceWeights(skeleton);
  std::vector<double> heights(skeleton.size(), 0.0);
  for (const Clip& clip : clips) {
    if (clip.frameCount() == 0) continue;
    const std::vector<Vec3> positions = jointPositions(skeleton, clip.pose(clip.frameCount() / 2));
    for (std::size_t j = 0; j < skeleton.size(); ++j) heights[j] = positions[j].y();
    break;
  }
  FeatureBasis basis;
  double total = 0.0;
  for (const double weight : weights) total += weight;
  for (std::size_t j = 0; j < skeleton.size(); ++j) {
    if (weights[j] == 0.0) continue;
    basis.joints.emplace_back(j);
    basis.weights.push_back(weights[j] / (total * static_cast<double>(kWindowFrames)));
    basis.heightsMetres.push_back(heights[j]);
  }
  return basis;
}

ClipFeatures::ClipFeatures(const Skeleton& skeleton, const FeatureBasis& basis, const Clip& clip)
    : frameCount_(clip.frameCount()),
      paddedCount_(wholePanels(frameCount_) * kPanelColumns),
      jointCount_(basis.joints.size()),
      centres_(frameCount_, Vec2::Zero()),
      frames_((wholePanels(frameCount_) + 1) * kSpaceTerms * jointCount_),
      motion_(wholePanels(frameCount_) * kFloorTerms * kMotionPoints),
      energies_(paddedCount_, 0.0F) {
  for (std::size_t f = 0; f < frameCount_; ++f) addFrame(basis, f, jointPositions(skeleton, clip.pose(f)));
  for (std::size_t w = 0; w < windowCount(); ++w) addMotion(w);
  for (std::size_t w = 0; w < windowCount(); w += kWindowsAtOnce) addEnergies(w);
}

std::size_t ClipFeatures::windowCount() const {
  return frameCount_ < kWindowFrames ? 0 : frameCount_ - kWindowFrames + 1;
}

void ClipFeatures::addFrame(const FeatureBasis& basis, std::size_t frame, std::span<const Vec3> positions) {
  Vec2 centre = Vec2::Zero();
  double total = 0.0;
  for (std::size_t k = 0; k < jointCount_; ++k) {
    centre += basis.weights[k] * onFloor(positions[basis.joints[k].value]);
    total += basis.weights[k];
  }
  centre /= total;
  centres_[frame] = centre;
  float* terms = columnOf(frames_, kSpaceTerms * jointCount_, frame);
  for (std::size_t k = 0; k < jointCount_; ++k, terms += kSpaceTerms * kPanelColumns) {
    const double root = std::sqrt(basis.weights[k]);
    const Vec3& position = positions[basis.joints[k].value];
    const Vec2 relative = (onFloor(position) - centre) * root;
    terms[0] = static_cast<float>(relative.x());
    terms[kPanelColumns] = static_cast<float>(relative.y());
    terms[2 * kPanelColumns] = static_cast<float>((position.y() - basis.heightsMetres[k]) * root);
  }
}

void ClipFeatures::addMotion(std::size_t window) {
  const Vec2 middle = centres_[window + kWindowReach];
  float* terms = columnOf(motion_, kFloorTerms * kMotionPoints, window);
  for (std::size_t p = 0; p < kPolynomials.size(); ++p, terms += kFloorTerms * kPanelColumns) {
    Vec2 sum = Vec2::Zero();
    for (std::size_t d = 0; d < kWindowFrames; ++d)
      sum += kPolynomials[p][d] * (centres_[window + d] - middle);
    sum /= std::sqrt(kSquaredLengths[p] * static_cast<double>(kWindowFrames));
    terms[0] = static_cast<float>(sum.x());
    terms[kPanelColumns] = static_cast<float>(sum.y());
  }
}

void ClipFeatures::addEnergies(std::size_t firstWindow) {
  std::array<float, kFramesOfWindows> along{};
  std::array<float, kFramesOfWindows> height{};
  for (std::size_t d = 0; d < kFramesOfWindows && firstWindow + d < frameCount_; ++d) {
    const float* frame = columnOf(frames_, kSpaceTerms * jointCount_, firstWindow + d);
    const SelfProducts products = selfProducts(frame, PointTerms::kSpace, jointCount_);
    along[d] = products.along;
    height[d] = products.height;
  }
  const std::array<float, kWindowsAtOnce> alongSums = windowSums(along);
  const std::array<float, kWindowsAtOnce> heightSums = windowSums(height);
  for (std::size_t k = 0; k < kWindowsAtOnce && firstWindow + k < windowCount(); ++k) {
    const float* motion = columnOf(motion_, kFloorTerms * kMotionPoints, firstWindow + k);
    const float ofMotion = selfProducts(motion, PointTerms::kFloor, kMotionPoints).along;
    energies_[firstWindow + k] = (ofMotion + alongSums[k]) + heightSums[k];
  }
}

}  // namespace stridegraph
