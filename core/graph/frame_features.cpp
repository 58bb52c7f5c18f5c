#include "graph/frame_features.h"

#include <array>
#include <cmath>

#include "graph/pose_distance.h"
#include "motion/kinematics.h"

namespace stridegraph {
namespace {

/// Orthogonal polynomials over five points, without the constant: each row sums to 0 and is orthogonal to the
/// others, so that products of the projections equal products of the centred paths.
constexpr std::array<std::array<double, kWindowFrames>, 4> kPolynomials = {
    {{-2, -1, 0, 1, 2}, {2, -1, -2, -1, 2}, {-1, 2, 0, -2, 1}, {1, -4, 6, -4, 1}}};
constexpr std::array<double, 4> kSquaredLengths = {10, 14, 10, 70};
static_assert(ClipFeatures::kMotionTerms == 2 * kPolynomials.size());

/// Product of a column with itself, term after term as the products of pairs are summed.
float selfProduct(const float* columns, std::size_t stride, std::size_t terms, std::size_t column) {
  float sum = 0.0F;
  for (std::size_t t = 0; t < terms; ++t) {
    const float value = columns[t * stride + column];
    sum += value * value;
  }
  return sum;
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
      stride_(clip.frameCount() + kPadding),
      jointCount_(basis.joints.size()),
      centres_(frameCount_, Vec2::Zero()),
      planar_(2 * jointCount_ * stride_, 0.0F),
      heights_(jointCount_ * stride_, 0.0F),
      motion_(kMotionTerms * stride_, 0.0F),
      energies_(stride_, 0.0) {
  for (std::size_t f = 0; f < frameCount_; ++f) addFrame(basis, f, jointPositions(skeleton, clip.pose(f)));
  for (std::size_t w = 0; w < windowCount(); ++w) {
    addMotion(w);
    addEnergy(w);
  }
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
  for (std::size_t k = 0; k < jointCount_; ++k) {
    const double root = std::sqrt(basis.weights[k]);
    const Vec3& position = positions[basis.joints[k].value];
    const Vec2 relative = (onFloor(position) - centre) * root;
    planar_[k * stride_ + frame] = static_cast<float>(relative.x());
    planar_[(jointCount_ + k) * stride_ + frame] = static_cast<float>(relative.y());
    heights_[k * stride_ + frame] = static_cast<float>((position.y() - basis.heightsMetres[k]) * root);
  }
}

void ClipFeatures::addMotion(std::size_t window) {
  const Vec2 middle = centres_[window + kWindowReach];
  for (std::size_t p = 0; p < kPolynomials.size(); ++p) {
    Vec2 sum = Vec2::Zero();
    for (std::size_t d = 0; d < kWindowFrames; ++d)
      sum += kPolynomials[p][d] * (centres_[window + d] - middle);
    sum /= std::sqrt(kSquaredLengths[p] * static_cast<double>(kWindowFrames));
    motion_[p * stride_ + window] = static_cast<float>(sum.x());
    motion_[(kPolynomials.size() + p) * stride_ + window] = static_cast<float>(sum.y());
  }
}

void ClipFeatures::addEnergy(std::size_t window) {
  double along = static_cast<double>(selfProduct(motion_.data(), stride_, kMotionTerms, window));
  double height = 0.0;
  for (std::size_t d = 0; d < kWindowFrames; ++d) {
    along += static_cast<double>(selfProduct(planar_.data(), stride_, 2 * jointCount_, window + d));
    height += static_cast<double>(selfProduct(heights_.data(), stride_, jointCount_, window + d));
  }
  energies_[window] = along + height;
}

}  // namespace stridegraph
