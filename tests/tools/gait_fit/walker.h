#pragma once

#include <functional>
#include <vector>

#include "gait_fit/track.h"

namespace stridegraph::gait_fit::testing {

/// How a made-up walker goes: speed (m/s) and turn rate (rad/s) at each moment (s).
struct Walk {
  double seconds = 6.0;
  std::function<double(double)> speed;
  std::function<double(double)> turnRate;
  double firstPhase = 0.3;
};

/// A walker made from core's own tables, feet not planted, so that everything a fit should find is known.
struct KnownWalk {
  Clip clip;
  std::vector<GaitState> states;  ///< One for each frame.
};
KnownWalk makeWalk(const Walk& walk, Gait gait = Gait::kWalk);

/// Walks at several speeds, straight and bending to both sides, 4 s each.
std::vector<KnownWalk> variedWalks(Gait gait = Gait::kWalk);

std::vector<Clip> clipsOf(const std::vector<KnownWalk>& walks);

/// Largest distance of a joint between two poses of the gait body, metres.
double largestDistance(const Pose& a, const Pose& b);

}  // namespace stridegraph::gait_fit::testing
