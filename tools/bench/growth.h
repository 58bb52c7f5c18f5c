#pragma once

#include <cstddef>
#include <vector>

#include "bench/bench_run.h"
#include "bench/measuring.h"
#include "walk/walk_planner.h"

namespace stridegraph::bench {

/// A library built from so many frames of varied gait clips ("frames"): seconds and pairs of frames compared
/// to build it, its size, how many transitions were found and how many kept, milliseconds to open it, and to
/// plan a walk (median of some random rooms).
GrowthRow growthAtFrames(std::size_t frames, const MeasureParams& params);

/// Walks through a room of 120 by 120 m with so many blocks ("rectangles"): milliseconds, medians of some
/// rooms of that kind.
GrowthRow growthAtRectangles(const WalkPlanner& planner, std::size_t rectangles, const MeasureParams& params);

/// So many walkers who cross one square (crossingScene): how many arrive, milliseconds to plan all and the
/// slowest of them, how near they come to one another, and how far they go.
GrowthRow growthAtWalkers(const WalkPlanner& planner, std::size_t walkers, const MeasureParams& params);

}  // namespace stridegraph::bench
