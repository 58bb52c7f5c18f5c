#pragma once

#include <vector>

namespace stridegraph {

/// What a share (0..1) of the values does not exceed, linearly between the two nearest ranks; 0 without
/// values.
double percentile(std::vector<double> values, double share);

}  // namespace stridegraph
