#include "walk/correction_blend.h"

#include <algorithm>
#include <cmath>

namespace stridegraph {
namespace {

struct End {
  FootCorrection value = FootCorrection::Zero();
  FootCorrection slope = FootCorrection::Zero();  ///< Per frame.
};

End endOf(const FootCorrection& inner, const FootCorrection& outer) {
  FootCorrection slope = outer - inner;
  const double speed = slope.head<3>().norm();
  if (speed > kLargestPlaceSlope) slope.head<3>() *= kLargestPlaceSlope / speed;
  for (Eigen::Index turn = 3; turn < slope.size(); ++turn)
    slope[turn] = std::clamp(slope[turn], -kLargestTurnSlope, kLargestTurnSlope);
  return {outer, slope};
}

End beginningOf(const PinnedStance& pinned) {
  End end = endOf(pinned.corrections[std::min<std::size_t>(1, pinned.corrections.size() - 1)],
                  pinned.corrections.front());
  end.slope = -end.slope;
  return end;
}

End endingOf(const PinnedStance& pinned) {
  const std::size_t last = pinned.corrections.size() - 1;
  return endOf(pinned.corrections[last - std::min<std::size_t>(1, last)], pinned.corrections[last]);
}

/// Frames first..next - 1 between an end at frame first - 1 and one at frame next.
void fill(const End& from, const End& to, std::size_t first, std::size_t next,
          std::vector<FootCorrection>& corrections) {
  const double span = static_cast<double>(next - first + 1);
  for (std::size_t f = first; f < next; ++f) {
    const double s = static_cast<double>(f - first + 1) / span;
    const double s2 = s * s;
    const double s3 = s2 * s;
    corrections[f] = from.value * (2 * s3 - 3 * s2 + 1) + from.slope * (span * (s3 - 2 * s2 + s)) +
                     to.value * (3 * s2 - 2 * s3) + to.slope * (span * (s3 - s2));
  }
}

/// Grows from nothing, without a corner, to 1 in the middle of -1..1.
double bell(double offset) {
  const double rest = 1.0 - offset * offset;
  return rest > 0.0 ? rest * rest : 0.0;
}

struct BellSums {
  double values = 0.0;
  double weights = 0.0;
};

/// Weighted sums over the frames within reach of one, which count for less the farther they are.
BellSums sumsAround(std::size_t frame, std::span<const double> values, std::span<const double> weights,
                    std::size_t reach) {
  BellSums sums;
  for (std::size_t g = frame - std::min(frame, reach); g < std::min(values.size(), frame + reach + 1); ++g) {
    const double offset =
        (static_cast<double>(g) - static_cast<double>(frame)) / static_cast<double>(reach + 1);
    sums.values += bell(offset) * weights[g] * values[g];
    sums.weights += bell(offset) * weights[g];
  }
  return sums;
}

}  // namespace

std::vector<FootCorrection> carryCorrections(std::span<const PinnedStance> stances, std::size_t frameCount,
                                             std::size_t blendFrames) {
  std::vector<FootCorrection> corrections(frameCount, FootCorrection::Zero());
  for (const PinnedStance& pinned : stances)
    std::copy(pinned.corrections.begin(), pinned.corrections.end(),
              corrections.begin() + static_cast<std::ptrdiff_t>(pinned.stance.first));
  for (std::size_t i = 0; i <= stances.size() && !stances.empty(); ++i) {
    // The free frames before stance i.
    const std::size_t first = i == 0 ? 0 : stances[i - 1].stance.last + 1;
    const std::size_t next = i == stances.size() ? frameCount : stances[i].stance.first;
    if (i > 0 && i < stances.size() && next - first < 2 * blendFrames) {
      fill(endingOf(stances[i - 1]), beginningOf(stances[i]), first, next, corrections);
      continue;
    }
    // At the ends of the clip a fade is cut off rather than hurried.
    std::vector<FootCorrection> fade(blendFrames, FootCorrection::Zero());
    if (i > 0) {
      fill(endingOf(stances[i - 1]), {}, 0, blendFrames, fade);
      for (std::size_t k = 0; k < std::min(blendFrames, next - first); ++k) corrections[first + k] = fade[k];
    }
    if (i < stances.size()) {
      fill({}, beginningOf(stances[i]), 0, blendFrames, fade);
      for (std::size_t k = 0; k < std::min(blendFrames, next - first); ++k)
        corrections[next - 1 - k] = fade[blendFrames - 1 - k];
    }
  }
  return corrections;
}

std::vector<double> smoothEnvelope(std::span<const double> values, std::size_t reach) {
  const std::size_t count = values.size();
  std::vector<double> largest(count, 0.0);
  for (std::size_t f = 0; f < count; ++f)
    for (std::size_t g = f - std::min(f, reach); g < std::min(count, f + reach + 1); ++g)
      largest[f] = std::max(largest[f], values[g]);
  const std::vector<double> even(count, 1.0);
  std::vector<double> result(count, 0.0);
  for (std::size_t f = 0; f < count; ++f) {
    const BellSums sums = sumsAround(f, largest, even, reach);
    result[f] = sums.values / sums.weights;
  }
  return result;
}

std::vector<double> smoothMean(std::span<const double> values, std::span<const double> weights,
                               std::size_t reach) {
  // So much that a single frame at the rim of the reach counts for little.
  constexpr double kNothing = 0.5;
  std::vector<double> result(values.size(), 0.0);
  for (std::size_t f = 0; f < result.size(); ++f) {
    const BellSums sums = sumsAround(f, values, weights, reach);
    if (sums.weights > 0.0) result[f] = sums.values / (sums.weights + kNothing);
  }
  return result;
}

}  // namespace stridegraph
