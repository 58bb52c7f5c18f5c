#include "graph/pose_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "base/check.h"
#include "motion/kinematics.h"

namespace stridegraph {
namespace {

constexpr std::array<std::string_view, 5> kHandWords = {"hand", "wrist", "palm", "finger", "thumb"};
constexpr std::array<std::string_view, 4> kTipEndings = {"end", "tip", "nub", "site"};

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

bool isHand(const std::string& lowerName) {
  return std::any_of(kHandWords.begin(), kHandWords.end(),
                     [&](std::string_view word) { return lowerName.find(word) != std::string::npos; });
}

bool isTip(const std::string& lowerName) {
  return std::any_of(kTipEndings.begin(), kTipEndings.end(),
                     [&](std::string_view ending) { return lowerName.ends_with(ending); });
}

}  // namespace

std::vector<double> distanceWeights(const Skeleton& skeleton) {
  std::vector<double> weights(skeleton.size(), 1.0);
  std::vector<bool> belowWrist(skeleton.size(), false);
  for (std::size_t j = 0; j < skeleton.size(); ++j) {
    const Joint& joint = skeleton.joints[j];
    const std::string name = lowerCase(joint.name);
    belowWrist[j] = isHand(name) || (joint.parent && belowWrist[joint.parent->value]);
    if (belowWrist[j] || joint.isEndSite || isTip(name)) weights[j] = 0.0;
  }
  // A skeleton of tips alone still has to be compared by something.
  if (std::all_of(weights.begin(), weights.end(), [](double w) { return w == 0.0; }) && !weights.empty())
    weights[0] = 1.0;
  return weights;
}

FloorTransform alignOnFloor(std::span<const Vec3> fixed, std::span<const Vec3> moved,
                            std::span<const double> weights) {
  STRIDEGRAPH_CHECK(fixed.size() == moved.size() && fixed.size() == weights.size());
  double total = 0.0;
  Vec2 fixedCentre = Vec2::Zero();
  Vec2 movedCentre = Vec2::Zero();
  for (std::size_t k = 0; k < fixed.size(); ++k) {
    total += weights[k];
    fixedCentre += weights[k] * onFloor(fixed[k]);
    movedCentre += weights[k] * onFloor(moved[k]);
  }
  STRIDEGRAPH_CHECK(total > 0.0);
  fixedCentre /= total;
  movedCentre /= total;
  // The turn by angle t makes the sum smallest where along cos(t) + across sin(t) is largest.
  double along = 0.0;
  double across = 0.0;
  for (std::size_t k = 0; k < fixed.size(); ++k) {
    const Vec2 a = onFloor(fixed[k]) - fixedCentre;
    const Vec2 b = onFloor(moved[k]) - movedCentre;
    along += weights[k] * (a.x() * b.x() + a.y() * b.y());
    across += weights[k] * (a.x() * b.y() - a.y() * b.x());
  }
  const Heading heading = Heading::alongDirection({across, along});
  return {fixedCentre - heading.rotate(movedCentre), heading};
}

double windowDistanceMetres(std::span<const Vec3> fixed, std::span<const Vec3> moved,
                            std::span<const double> weights) {
  const FloorTransform fixedFromMoved = alignOnFloor(fixed, moved, weights);
  double sum = 0.0;
  double total = 0.0;
  for (std::size_t k = 0; k < fixed.size(); ++k) {
    sum += weights[k] * (fixed[k] - fixedFromMoved.apply(moved[k])).squaredNorm();
    total += weights[k];
  }
  return std::sqrt(sum / total);
}

std::vector<Vec3> windowPositions(const Skeleton& skeleton, const Clip& clip, std::size_t frame) {
  STRIDEGRAPH_CHECK(frame >= kWindowReach && frame + kWindowReach < clip.frameCount());
  std::vector<Vec3> window;
  for (std::size_t f = frame - kWindowReach; f <= frame + kWindowReach; ++f) {
    const std::vector<Vec3> positions = jointPositions(skeleton, clip.pose(f));
    window.insert(window.end(), positions.begin(), positions.end());
  }
  return window;
}

std::vector<double> windowWeights(const Skeleton& skeleton) {
  const std::vector<double> ofFrame = distanceWeights(skeleton);
  std::vector<double> weights;
  for (std::size_t d = 0; d < kWindowFrames; ++d)
    weights.insert(weights.end(), ofFrame.begin(), ofFrame.end());
  return weights;
}

double poseDistanceMetres(const Skeleton& skeleton, const Clip& a, std::size_t frameOfA, const Clip& b,
                          std::size_t frameOfB) {
  return windowDistanceMetres(windowPositions(skeleton, a, frameOfA), windowPositions(skeleton, b, frameOfB),
                              windowWeights(skeleton));
}

}  // namespace stridegraph
