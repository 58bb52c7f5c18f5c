#pragma once

#include <vector>

#include "gait_fit/track.h"

namespace stridegraph::gait_fit {

/// One foot near the middle of its stance: how far the trunk leans over it to the side, seen from the left
/// foot (samples of the right foot are mirrored).
struct LeanSample {
  double sideways = 0.0;  ///< Speed times turn rate, m/s^2, to the left
  double captured = 0.0;  ///< degrees, to the left
  double model = 0.0;
};

/// Of all such frames of a track away from its ends.
std::vector<LeanSample> leanSamples(const Track& track, const GaitTable& table);

/// Degrees for each m/s^2: least squares with an intercept for a foot's own side; 0 where nothing turns.
struct LeanSlopes {
  double captured = 0.0;
  double model = 0.0;
};
LeanSlopes leanSlopes(const std::vector<LeanSample>& samples);

}  // namespace stridegraph::gait_fit
