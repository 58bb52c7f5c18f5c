#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stridegraph {

/// Writes numbers and texts in few bytes.
class PackedWriter {
 public:
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

  void byte(std::uint8_t value) { bytes_.push_back(value); }
  /// Little endian, always this many bytes, 1..8.
  void fixed(std::uint64_t value, int byteCount);
  /// Seven bits to the byte, lowest first.
  void varint(std::uint64_t value);
  /// Multiples of 0.0001 up to 1e11 in one to seven bytes, every other double in nine; always exact.
  void number(double value);
  void text(std::string_view value);

 private:
  std::vector<std::uint8_t> bytes_;
};

/// Reads what PackedWriter wrote. Reading past the end, or what it never writes, gives zeros and makes
/// failed() true from then on.
class PackedReader {
 public:
  explicit PackedReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool failed() const { return failed_; }
  std::size_t bytesLeft() const { return bytes_.size(); }

  std::uint8_t byte();
  std::uint64_t fixed(int byteCount);
  std::uint64_t varint();
  double number();
  std::string text();
  /// A number of elements to come, each at least `leastBytes` long: 0 and failed() when they cannot fit.
  std::size_t count(std::size_t leastBytes);

 private:
  std::span<const std::uint8_t> bytes_;
  bool failed_ = false;
};

}  // namespace stridegraph
