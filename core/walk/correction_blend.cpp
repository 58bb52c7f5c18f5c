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

/// The bell at offsets of 0..reach frames.
std::vector<double> bellOver(std::size_t reach) {
  std::vector<double> values(reach + 1);
  for (std::size_t away = 0; away <= reach; ++away)
    values[away] = bell(static_cast<double>(away) / static_cast<double>(reach + 1));
  return values;
}

/// Frames around one.
struct FrameRange {
  std::size_t first = 0;
  std::size_t end = 0;
};

FrameRange around(std::size_t frame, std::size_t reach, std::size_t count) {
  return {frame - std::min(frame, reach), std::min(count, frame + reach + 1)};
}

std::size_t away(std::size_t a, std::size_t b) {
  return a < b ? b - a : a - b;
}

/// Calls visit(frame) for every frame within reach of one for which holds(frame).
template <typename Holds, typename Visit>
void visitNear(std::size_t count, std::size_t reach, const Holds& holds, const Visit& visit) {
  std::size_t next = 0;
  for (std::size_t f = 0; f < count; ++f) {
    if (!holds(f)) continue;
    const FrameRange range = around(f, reach, count);
    for (next = std::max(next, range.first); next < range.end; ++next) visit(next);
  }
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
  const std::vector<double> bells = bellOver(reach);
  std::vector<double> largest(count, 0.0);
  std::vector<double> result(count, 0.0);
  visitNear(
      count, reach, [&](std::size_t f) { return values[f] > 0.0; },
      [&](std::size_t f) {
        const FrameRange range = around(f, reach, count);
        for (std::size_t g = range.first; g < range.end; ++g) largest[f] = std::max(largest[f], values[g]);
      });
  visitNear(
      count, reach, [&](std::size_t f) { return largest[f] > 0.0; },
      [&](std::size_t f) {
        const FrameRange range = around(f, reach, count);
        double sum = 0.0;
        double weights = 0.0;
        for (std::size_t g = range.first; g < range.end; ++g) {
          sum += bells[away(f, g)] * largest[g];
          weights += bells[away(f, g)];
        }
        result[f] = sum / weights;
      });
  return result;
}

std::vector<double> smoothMean(std::span<const double> values, std::span<const double> weights,
                               std::size_t reach) {
  // So much that a single frame at the rim of the reach counts for little.
  constexpr double kNothing = 0.5;
  const std::size_t count = values.size();
  const std::vector<double> bells = bellOver(reach);
  std::vector<double> result(count, 0.0);
  visitNear(
      count, reach, [&](std::size_t f) { return weights[f] > 0.0; },
      [&](std::size_t f) {
        const FrameRange range = around(f, reach, count);
        double sum = 0.0;
        double weightSum = 0.0;
        for (std::size_t g = range.first; g < range.end; ++g) {
          const double weight = bells[away(f, g)] * weights[g];
          sum += weight * values[g];
          weightSum += weight;
        }
        result[f] = sum / (weightSum + kNothing);
      });
  return result;
}

}  // namespace stridegraph
