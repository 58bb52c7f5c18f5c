#pragma once

#include <cstddef>
#include <cstdint>

namespace stridegraph {

/// Seeded random numbers, the same on every machine and library: SplitMix64 (Steele, Lea and Flood 2014) with
/// its own mapping of bits to numbers.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  /// 64 random bits.
  std::uint64_t bits();
  /// Uniform in [0, 1), 53 bits.
  double uniform();
  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform in 0..count-1; count >= 1. Biased by less than count / 2^64.
  std::size_t below(std::size_t count);

 private:
  std::uint64_t state_;
};

}  // namespace stridegraph
