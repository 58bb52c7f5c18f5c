#pragma once

#include <algorithm>
#include <cstddef>
#include <ctime>

namespace stridegraph::bench {

/// The most that some work, repeated, did in a second of processor time: other programs on the machine can
/// only take away from it.
class Fastest {
 public:
  /// `work` says how much it did.
  template <typename Work>
  void time(Work&& work) {
    const std::clock_t begin = std::clock();
    const std::size_t done = work();
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    if (seconds > 0.0) perSecond_ = std::max(perSecond_, static_cast<double>(done) / seconds);
  }
  double perSecond() const { return perSecond_; }

 private:
  double perSecond_ = 0.0;
};

}  // namespace stridegraph::bench
