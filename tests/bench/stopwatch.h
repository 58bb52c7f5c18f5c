#pragma once

#include <algorithm>
#include <ctime>
#include <limits>

namespace stridegraph::bench {

/// The least processor time, in seconds, that `work` took in some runs: other programs on the machine can
/// only add to it.
template <typename Work>
double leastSeconds(int runs, Work&& work) {
  double least = std::numeric_limits<double>::max();
  for (int run = 0; run < runs; ++run) {
    const std::clock_t begin = std::clock();
    work();
    least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return least;
}

}  // namespace stridegraph::bench
