#pragma once

#include <cstddef>
#include <vector>

namespace stridegraph {

/// 0 up to 0, 1 from 1 on, between them smooth (3 t^2 - 2 t^3).
double smoothStep(double x);

/// Each value's mean with its neighbours up to `reach` away, weighted by a raised cosine that ends just
/// beyond them; the ends go on. Sums are kept but for what lies near the ends.
std::vector<double> bellMean(const std::vector<double>& values, std::size_t reach);

}  // namespace stridegraph
