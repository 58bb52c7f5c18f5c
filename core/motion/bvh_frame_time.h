#pragma once

#include <optional>
#include <string_view>

#include "base/result.h"
#include "motion/bvh_scanner.h"

namespace stridegraph {

/// What a BVH says of time.
struct BvhFrameTime {
  double framesPerSecond = 30.0;
  std::optional<Warning> warning;  ///< Where the time was given in milliseconds.
};

/// Reads the number after "Frame Time:". Up to kLongestBvhFrameSeconds it is seconds: the reciprocal of a
/// whole rate when that lies within the rounding of its digits, so that 0.0333333 and 0.033 mean 30 frames a
/// second. A greater number is milliseconds where a customary rate lies within its digits and the number
/// itself is no customary rate: 33.333333 means 30 frames a second, with a warning (WarningTopic::kTime).
/// Fails with kBvhSyntax where there is no number, and with kBvhValue where no reading is clearly right:
/// below kShortestBvhFrameSeconds, and greater numbers such as 30 or 120, which may be a rate.
Result<BvhFrameTime> parseBvhFrameTime(BvhScanner& scanner);

}  // namespace stridegraph
