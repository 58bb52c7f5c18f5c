#include "motion/up_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "motion/bvh_reader.h"

namespace stridegraph {
namespace {

constexpr std::size_t kPlusY = 2;
constexpr std::size_t kPlusZ = 4;
constexpr std::array<std::string_view, kDirections> kDirectionNames = {"x", "-x", "y", "-y", "z", "-z"};

/// Log odds before anything is seen, against y up.
constexpr std::array<double, kDirections> kPriors = {-4.0, -5.0, 0.0, -4.0, -1.0, -5.0};

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

double logOdds(const BodyEvidence& evidence, std::size_t direction) {
  const auto axis = static_cast<Eigen::Index>(direction / 2);
  const Vec3 up = directionVector(direction);
  double odds = kPriors[direction];
  odds += 2.5 * standingOut(evidence.extents.posed, axis);
  odds += 1.0 * standingOut(evidence.extents.rest, axis);
  if (evidence.size <= 0.0) return odds;
  odds += 5.0 * fall(evidence.rootRange[axis] / evidence.size, 0.4, 1.2);
  odds += 3.0 * fall(evidence.levelSpread[direction] / evidence.size, 0.05, 0.5);
  if (evidence.slip) odds += 3.0 * fall((*evidence.slip)[direction], 0.2, 0.8);
  if (evidence.feetToHead)
    odds += 3.0 * std::clamp(evidence.feetToHead->dot(up) / (0.6 * evidence.size), -1.0, 1.0);
  if (evidence.feetToHeadAtRest)
    odds += 1.0 * std::clamp(evidence.feetToHeadAtRest->dot(up) / (0.6 * evidence.size), -1.0, 1.0);
  return odds;
}

}  // namespace

std::array<double, kDirections> upLikelihoods(const BodyEvidence& evidence) {
  std::array<double, kDirections> likelihoods;
  for (std::size_t d = 0; d < kDirections; ++d) likelihoods[d] = logOdds(evidence, d);
  const double greatest = *std::max_element(likelihoods.begin(), likelihoods.end());
  double sum = 0.0;
  for (double& likelihood : likelihoods) sum += likelihood = std::exp(likelihood - greatest);
  for (double& likelihood : likelihoods) likelihood /= sum;
  return likelihoods;
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
