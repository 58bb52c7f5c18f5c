#include "motion/gait_curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stridegraph {

double smoothStep(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

std::vector<double> bellMean(const std::vector<double>& values, std::size_t reach) {
  const auto wide = static_cast<std::ptrdiff_t>(reach);
  const auto last = static_cast<std::ptrdiff_t>(values.size()) - 1;
  std::vector<double> result(values.size(), 0.0);
  for (std::ptrdiff_t i = 0; i <= last; ++i) {
    double sum = 0.0;
    double weights = 0.0;
    for (std::ptrdiff_t k = -wide; k <= wide; ++k) {
      const double weight =
          1.0 + std::cos(std::numbers::pi * static_cast<double>(k) / static_cast<double>(wide + 1));
      sum += weight * values[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i + k, 0, last))];
      weights += weight;
    }
    result[static_cast<std::size_t>(i)] = sum / weights;
  }
  return result;
}

}  // namespace stridegraph
