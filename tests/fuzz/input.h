#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "target.h"

namespace stridegraph::fuzz {

/// Reads choices and numbers off the front of a fuzzer's bytes; zeros once they are used up.
class Input {
 public:
  explicit Input(Bytes bytes) : bytes_(bytes) {}

  std::size_t bytesLeft() const { return bytes_.size(); }

  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const std::uint8_t first = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return first;
  }

  std::uint32_t word() {
    const std::uint32_t low = byte();
    return low | static_cast<std::uint32_t>(byte()) << 8U;
  }

  /// 0..count-1; count is 1 to 256.
  std::size_t below(std::size_t count) { return byte() % count; }

  bool chance() { return (byte() & 1U) != 0; }

  /// low..high in 65536 steps.
  double number(double low, double high) { return low + (high - low) * word() / 65535.0; }

  /// The same, but for words from 0xfff0 on, which stand for numbers that break arithmetic.
  double oddNumber(double low, double high) {
    const std::uint32_t step = word();
    if (step >= kFirstOdd) return kOddNumbers[step - kFirstOdd];
    return low + (high - low) * step / (kFirstOdd - 1);
  }

  static constexpr std::uint32_t kFirstOdd = 0xfff0;
  static constexpr double kOddNumbers[16] = {0.0,
                                             -0.0,
                                             1.0,
                                             -1.0,
                                             1e-9,
                                             -1e-9,
                                             1e-300,
                                             1e300,
                                             1e9,
                                             -1e9,
                                             1e18,
                                             4e9,
                                             -4e9,
                                             std::numeric_limits<double>::infinity(),
                                             -std::numeric_limits<double>::infinity(),
                                             std::numeric_limits<double>::quiet_NaN()};

 private:
  Bytes bytes_;
};

}  // namespace stridegraph::fuzz
