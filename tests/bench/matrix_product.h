#pragma once

#include <optional>

namespace stridegraph::bench {

/// What this machine's core does at best: 32 bit floating-point operations per second, in thousand millions,
/// of a large matrix product (Eigen, with AVX2 and fused operations where the build is for x86-64). Nothing
/// on a machine without these instructions.
std::optional<double> matrixProductGigaflops();

}  // namespace stridegraph::bench
