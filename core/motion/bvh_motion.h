#pragma once

#include <cstddef>
#include <vector>

#include "base/result.h"
#include "motion/bvh_hierarchy.h"
#include "motion/bvh_scanner.h"

namespace stridegraph {

/// The rows of a MOTION, as numbers.
struct BvhMotion {
  double framesPerSecond = 30.0;
  std::size_t frameCount = 0;
  std::size_t columns = 0;
  std::vector<double> values;  ///< frameCount x columns, row by row.
  Warnings warnings;
};

/// Reads MOTION to the end of the text: the declared number of frames, the frame time
/// (parseBvhFrameTime()) and the rows (parseBvhRows()), which fail as these do. Fails with kBvhSyntax or
/// kBvhValue also where no frames are declared, or more than motion/bvh_limits.h allows for such a skeleton.
Result<BvhMotion> parseBvhMotion(BvhScanner& scanner, const BvhHierarchy& hierarchy);

}  // namespace stridegraph
