#pragma once

#include <cstddef>

#include "scene/scene.h"
#include "walk/plan.h"

namespace stridegraph::bench {

/// So many walkers, 1 or more, evenly on a circle, who all cross its middle to the place opposite and face it
/// at first: all ways meet where all would be at the same time. The square floor has nothing on it and is as
/// large as it takes for them to stand 2.7 m apart, at least 20 m.
Scene crossingScene(std::size_t walkers);

/// How a crossing went.
struct Crossing {
  std::size_t arrived = 0;
  double slowestMilliseconds = 0.0;  ///< Of the walker whose plan took longest.
  /// Smallest distance of the rims of any two, over all frames until the last arrives, metres; negative where
  /// they touch, infinite for one walker. Who has no walk stays at its start, who has arrived at its end.
  double leastGapMetres = 0.0;
  std::size_t contactFrames = 0;  ///< Frames in which any two touch.
  double meanLengthRatio = 0.0;   ///< Of those who arrived: metres walked over metres straight across.
};

/// `plan` is of the scene.
Crossing crossingOf(const Scene& scene, const Plan& plan);

}  // namespace stridegraph::bench
