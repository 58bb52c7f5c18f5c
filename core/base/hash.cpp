#include "base/hash.h"

namespace stridegraph {
namespace {

constexpr std::uint64_t kPrime = 0x100000001b3ULL;

std::uint64_t mix(std::uint64_t hash, std::uint8_t byte) {
  return (hash ^ byte) * kPrime;
}

}  // namespace

std::uint64_t stableHash(std::span<const std::uint8_t> bytes, std::uint64_t seed) {
  for (const std::uint8_t byte : bytes) seed = mix(seed, byte);
  return seed;
}

std::uint64_t stableHash(std::string_view text, std::uint64_t seed) {
  for (const char c : text) seed = mix(seed, static_cast<std::uint8_t>(c));
  return seed;
}

std::string hexDigits(std::uint64_t hash) {
  std::string digits(16, '0');
  for (std::size_t i = 16; i-- > 0; hash >>= 4) digits[i] = "0123456789abcdef"[hash & 15];
  return digits;
}

}  // namespace stridegraph
