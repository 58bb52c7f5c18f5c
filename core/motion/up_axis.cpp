#include "motion/up_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "motion/bvh_reader.h"

namespace stridegraph {
namespace {

constexpr std::size_t kPlusY = 2;
constexpr std::size_t kPlusZ = 4;
constexpr std::array<std::string_view, kDirections> kDirectionNames = {"x", "-x", "y", "-y", "z", "-z"};

/// Log odds before anything is seen, against y up.
constexpr std::array<double, kDirections> kPriors = {-4.2, -4.7, 0.0, -4.2, -0.2, -4.7};
/// How often a body does not stand: it lies, crawls or hangs, in all frames or at rest, where axes may be
/// any.
constexpr double kPosedOtherwise = 0.35;
constexpr double kRestsOtherwise = 0.5;
/// Weights of evidence, in log odds.
constexpr double kStandingOut = 3.0;
constexpr double kHeadAbove = 4.0;
constexpr double kTravel = 5.0;
constexpr double kLevel = 1.0;
constexpr double kSlip = 6.0;
/// From foot to head, as a share of the body's size.
constexpr double kUsualFeetToHead = 0.6;

using PerDirection = std::array<double, kDirections>;

/// Falls from 0 at `from` to -1 at `to` and stays there.
double fall(double value, double from, double to) {
  return -std::clamp((value - from) / (to - from), 0.0, 1.0);
}

/// How far an extent stands out: the logarithm of its ratio to the longest other one, within -1..1.
double standingOut(const Vec3& extent, Eigen::Index axis) {
  double other = 0.0;
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (i != axis) other = std::max(other, extent[i]);
  }
  constexpr double kTiny = 1e-9;
  const double least = kTiny + kTiny * extent.maxCoeff();
  return std::clamp(std::log((extent[axis] + least) / (other + least)), -1.0, 1.0);
}

/// Log odds as likelihoods that add to 1.
PerDirection normalised(PerDirection odds) {
  const double greatest = *std::max_element(odds.begin(), odds.end());
  double sum = 0.0;
  for (double& value : odds) sum += value = std::exp(value - greatest);
  for (double& value : odds) value /= sum;
  return odds;
}

/// Log odds by the shape of a body that stands, unless, with a probability of `otherwise`, it does not.
PerDirection shapeOdds(const BodyEvidence& evidence, const Vec3& extent,
                       const std::optional<Vec3>& feetToHead, double otherwise) {
  PerDirection odds = {};
  for (std::size_t d = 0; d < kDirections; ++d) {
    odds[d] = kStandingOut * standingOut(extent, static_cast<Eigen::Index>(d / 2));
    if (!feetToHead || evidence.size <= 0.0) continue;
    const double above = feetToHead->dot(directionVector(d)) / (kUsualFeetToHead * evidence.size);
    odds[d] += kHeadAbove * std::clamp(above, -1.0, 1.0);
  }
  odds = normalised(odds);
  for (double& value : odds)
    value = std::log((1.0 - otherwise) * value + otherwise / static_cast<double>(kDirections));
  return odds;
}

/// Log odds by how the body moves: it travels in the plane of the floor, on which its lowest joint stands.
double motionOdds(const BodyEvidence& evidence, std::size_t direction) {
  if (evidence.size <= 0.0) return 0.0;
  const double travelled = evidence.rootRange[static_cast<Eigen::Index>(direction / 2)] / evidence.size;
  double odds = kTravel * fall(travelled, 0.4, 1.2);
  odds += kLevel * fall(evidence.levelSpread[direction] / evidence.size, 0.05, 0.5);
  if (evidence.slip) odds += kSlip * fall((*evidence.slip)[direction], 0.2, 0.8);
  return odds;
}

}  // namespace

std::array<double, kDirections> upLikelihoods(const BodyEvidence& evidence) {
  const PerDirection posed =
      shapeOdds(evidence, evidence.extents.posed, evidence.feetToHead, kPosedOtherwise);
  const PerDirection atRest =
      shapeOdds(evidence, evidence.extents.rest, evidence.feetToHeadAtRest, kRestsOtherwise);
  PerDirection odds = kPriors;
  for (std::size_t d = 0; d < kDirections; ++d) odds[d] += posed[d] + atRest[d] + motionOdds(evidence, d);
  return normalised(odds);
}

UpGuess inferUpAxis(const BodyEvidence& evidence, Warnings& warnings) {
  const std::array<double, kDirections> likelihoods = upLikelihoods(evidence);
  const bool isZ = likelihoods[kPlusZ] > likelihoods[kPlusY];
  const UpGuess guess{isZ ? UpAxis::kZ : UpAxis::kY, likelihoods[isZ ? kPlusZ : kPlusY]};
  const auto warn = [&](std::string message) {
    warnings.push_back({std::move(message), {}, WarningTopic::kUpAxis});
  };
  const Vec3& posed = evidence.extents.posed;
  const std::string_view name = isZ ? "z" : "y";
  const auto best = static_cast<std::size_t>(std::max_element(likelihoods.begin(), likelihoods.end()) -
                                             likelihoods.begin());
  if (likelihoods[best] > guess.confidence) {
    warn(fmt::format(
        "{} is taken as up, but the body seems to stand along {}, and only y or z up can be read: "
        "turn it where it was exported",
        name, kDirectionNames[best]));
  } else if (guess.confidence < kDoubtfulConfidence) {
    warn(
        fmt::format("{} is taken as up, which is doubtful: the body reaches {:.4g} units along y and {:.4g} "
                    "along z. If it lies on its side, choose {} as the up axis (--up {})",
                    name, posed.y(), posed.z(), isZ ? "y" : "z", isZ ? "y" : "z"));
  } else if (isZ) {
    warn(fmt::format("z is understood as up: the body reaches {:.4g} units along z and {:.4g} along y",
                     posed.z(), posed.y()));
  }
  return guess;
}

}  // namespace stridegraph
