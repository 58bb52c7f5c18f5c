#pragma once

#include <cstddef>
#include <vector>

#include "math/random.h"

namespace stridegraph {

/// How somebody's steps differ from one to the next: not white but remembered (Hausdorff, Peng, Ladin, Wei
/// and Goldberger 1995 found strides correlated over many; here each step keeps kMemory of what the one
/// before had, an autoregressive process of first order). Mean 0, standard deviation 1, the same for the same
/// generator state.
class StepNoise {
 public:
  /// Draws values for the steps 0..steps.
  StepNoise(Random& random, std::size_t steps);

  /// The value after so many steps (not whole: between two steps it goes over smoothly). Held at the ends.
  double at(double steps) const;

  static constexpr double kMemory = 0.6;

 private:
  std::vector<double> values_;
};

}  // namespace stridegraph
