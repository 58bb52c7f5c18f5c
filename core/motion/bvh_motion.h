#pragma once

#include <cstddef>
#include <vector>

#include "base/result.h"
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

/// Reads MOTION to the end of the text. Rows may be wrapped. Where a text holds other than the declared
/// frames, its complete rows are used, with a warning. A frame time is the reciprocal of a whole rate when
/// that lies within the rounding of its digits: 0.0333333 and 0.033 mean 30 frames a second. Fails with
/// kBvhSyntax or kBvhValue: no frames, numbers that are none, a frame time outside 1e-6..1000 seconds, and,
/// before anything is allocated, more frames than the text's size can hold.
Result<BvhMotion> parseBvhMotion(BvhScanner& scanner, std::size_t columns);

}  // namespace stridegraph
