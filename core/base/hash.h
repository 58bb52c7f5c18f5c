#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace stridegraph {

inline constexpr std::uint64_t kHashSeed = 0xcbf29ce484222325ULL;

/// FNV-1a, 64 bits (Fowler, Noll and Vo 1991): the same on every machine, so that it may be stored and
/// compared across programs. Pass an earlier hash as `seed` to go on with it.
std::uint64_t stableHash(std::span<const std::uint8_t> bytes, std::uint64_t seed = kHashSeed);
std::uint64_t stableHash(std::string_view text, std::uint64_t seed = kHashSeed);

/// Sixteen lower-case hexadecimal digits.
std::string hexDigits(std::uint64_t hash);

}  // namespace stridegraph
