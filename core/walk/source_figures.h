#pragma once

#include <vector>

#include "graph/library.h"
#include "motion/motion_limits.h"

namespace stridegraph {

/// What the clips of a library do, for comparing walks with them. Computed once for a library.
struct SourceFigures {
  MotionLimits limits;                   ///< capturedLimits().
  double footSkateCmPerSecond = 0.0;     ///< The mean of the clips' footSkate().
  std::vector<double> footFloorsMetres;  ///< For each contact joint the lowest of its clips' footFloors().
};

SourceFigures sourceFigures(const MotionLibrary& library);

}  // namespace stridegraph
