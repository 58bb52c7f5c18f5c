#pragma once

#include <vector>

#include "base/clock.h"
#include "bench/measuring.h"

namespace stridegraph::bench {

/// How long OMPL's planners may take, milliseconds.
struct OmplParams {
  double mostMilliseconds = 1000.0;   ///< Then they are said to have spent their budget.
  double improveMilliseconds = 50.0;  ///< BIT* goes on for so long to find shorter paths.
  MillisecondClock clock;
};

/// "ompl-prm", "ompl-rrt-connect" and "ompl-bit-star" (Sucan, Moll and Kavraki 2012). They ask the same exact
/// questions of the room as our planners, and the paths of the first two are simplified by OMPL, as ours are
/// by us. They cannot say that there is no way, but search until their time is spent: any status but
/// pathStatusName()'s is OMPL's own.
std::vector<PathMethod> omplMethods(const OmplParams& params);

}  // namespace stridegraph::bench
