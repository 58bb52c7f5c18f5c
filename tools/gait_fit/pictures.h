#pragma once

#include <string>
#include <vector>

#include "gait_fit/fit.h"

namespace stridegraph::gait_fit {

struct Picture {
  std::string name;  ///< File name without ".svg".
  std::string svg;
};

/// Captured against synthesised: stick figures at eight phases of the cycle from the side and from the front,
/// for the straightest and for the sharpest clip; where the feet stand along the sharpest clip, from above;
/// the lean of the trunk over sideways acceleration. Names begin with `gait`.
std::vector<Picture> picturesOf(const GaitFit& fit, const GaitTable& table, const std::string& gait);

}  // namespace stridegraph::gait_fit
