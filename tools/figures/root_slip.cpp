#include "figures/root_slip.h"

#include <algorithm>
#include <cmath>

namespace stridegraph::figures {

std::vector<double> sidewaysSteps(std::span<const FloorTransform> track, const Heading& facingOffset) {
  std::vector<double> steps;
  for (std::size_t f = 0; f + 1 < track.size(); ++f) {
    const Heading facing = blend(track[f].heading, track[f + 1].heading, 0.5) - facingOffset;
    const FloorTransform midway{Vec2::Zero(), facing};
    steps.push_back((midway.inverse() * Vec2(track[f + 1].translation - track[f].translation)).x());
  }
  return steps;
}

double sidewaysSlip(std::span<const FloorTransform> blended, std::span<const FloorTransform> source,
                    std::span<const FloorTransform> target, const Heading& facingOffset) {
  const std::vector<double> ofBlend = sidewaysSteps(blended, facingOffset);
  const std::vector<double> ofSource = sidewaysSteps(source, facingOffset);
  const std::vector<double> ofTarget = sidewaysSteps(target, facingOffset);
  double slip = 0.0;
  for (std::size_t f = 0; f < ofBlend.size(); ++f) {
    const auto [low, high] = std::minmax(ofSource[f], ofTarget[f]);
    slip += std::abs(ofBlend[f] - std::clamp(ofBlend[f], low, high));
  }
  return slip;
}

}  // namespace stridegraph::figures
