#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/hash.h"

namespace stridegraph {

/// Hash of a file that holds its own hash: the eight bytes at `hashPlace` count as zeros.
inline std::uint64_t hashAround(std::span<const std::uint8_t> bytes, std::size_t hashPlace) {
  constexpr std::uint8_t kZeros[sizeof(std::uint64_t)] = {};
  std::uint64_t hash = stableHash(bytes.first(hashPlace));
  hash = stableHash(kZeros, hash);
  return stableHash(bytes.subspan(hashPlace + sizeof(kZeros)), hash);
}

}  // namespace stridegraph
