#include "scene/packed_bytes.h"

#include <cmath>

#include "base/bits.h"

namespace stridegraph {

namespace {

constexpr double kStepsPerUnit = 10'000.0;
/// Whole numbers of steps up to here are exact as doubles, with a bit to spare for each of sign and tag.
constexpr double kMostSteps = 1e15;
constexpr std::uint64_t kExactTag = 1;

}  // namespace

void PackedWriter::fixed(std::uint64_t value, int byteCount) {
  for (int i = 0; i < byteCount; ++i) byte(static_cast<std::uint8_t>(value >> static_cast<unsigned>(8 * i)));
}

void PackedWriter::varint(std::uint64_t value) {
  std::uint64_t rest = value;
  for (; rest >= 128; rest >>= 7U) byte(static_cast<std::uint8_t>(rest | 128U));
  byte(static_cast<std::uint8_t>(rest));
}

void PackedWriter::number(double value) {
  const double steps = std::round(value * kStepsPerUnit);
  const bool isStepped = std::abs(steps) <= kMostSteps &&
                         bitCast<std::uint64_t>(steps / kStepsPerUnit) == bitCast<std::uint64_t>(value);
  if (!isStepped) {
    varint(kExactTag);
    fixed(bitCast<std::uint64_t>(value), 8);
    return;
  }
  // Lowest bit: the tag; next: the sign.
  const auto magnitude = static_cast<std::uint64_t>(std::abs(steps));
  varint((magnitude << 2U) | (std::signbit(steps) ? 2U : 0U));
}

void PackedWriter::text(std::string_view value) {
  varint(value.size());
  bytes_.insert(bytes_.end(), value.begin(), value.end());
}

std::uint8_t PackedReader::byte() {
  if (bytes_.empty()) failed_ = true;
  if (failed_) return 0;
  const std::uint8_t value = bytes_.front();
  bytes_ = bytes_.subspan(1);
  return value;
}

std::uint64_t PackedReader::fixed(int byteCount) {
  std::uint64_t value = 0;
  for (int i = 0; i < byteCount; ++i)
    value |= static_cast<std::uint64_t>(byte()) << static_cast<unsigned>(8 * i);
  return failed_ ? 0 : value;
}

std::uint64_t PackedReader::varint() {
  std::uint64_t value = 0;
  for (unsigned shift = 0; shift < 64; shift += 7) {
    const std::uint8_t next = byte();
    value |= static_cast<std::uint64_t>(next & 127U) << shift;
    if (next < 128) return failed_ ? 0 : value;
  }
  failed_ = true;
  return 0;
}

double PackedReader::number() {
  const std::uint64_t packed = varint();
  if (packed == kExactTag) return bitCast<double>(fixed(8));
  if ((packed & kExactTag) != 0) failed_ = true;
  const double steps = static_cast<double>(packed >> 2U);
  return ((packed & 2U) != 0 ? -steps : steps) / kStepsPerUnit;
}

std::string PackedReader::text() {
  const std::size_t size = count(1);
  const std::string value(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(size));
  bytes_ = bytes_.subspan(size);
  return value;
}

std::size_t PackedReader::count(std::size_t leastBytes) {
  const std::uint64_t value = varint();
  if (value > bytes_.size() / leastBytes) failed_ = true;
  return failed_ ? 0 : static_cast<std::size_t>(value);
}

}  // namespace stridegraph
