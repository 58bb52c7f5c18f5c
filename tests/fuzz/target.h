#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace stridegraph::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// Says which promise of core does not hold for the bytes at hand.
class BrokenPromise : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Throws BrokenPromise with this sentence unless the condition holds.
inline void require(bool condition, std::string_view promise) {
  if (!condition) throw BrokenPromise(std::string(promise));
}

/// Each takes any bytes and throws BrokenPromise where core breaks a promise. The same bytes do the same.
void tryBvh(Bytes bytes);      ///< A motion file: read, written, read again.
void tryLibrary(Bytes bytes);  ///< Clips made from the bytes become a library, at once and by appending.
void tryLink(Bytes bytes);     ///< The inside of a link, or a scene made from the bytes as a link.
void tryPlan(Bytes bytes);     ///< A scene and options made from the bytes: planned, and planned onward.
void tryScene(Bytes bytes);    ///< A scene's JSON: read, written, read again.
void trySgraph(Bytes bytes);   ///< A library file, or alterations of a sound one: opened and walked with.

struct Target {
  std::string_view name;
  void (*run)(Bytes bytes);
};

inline constexpr std::array kTargets = {
    Target{"bvh", tryBvh},   Target{"library", tryLibrary}, Target{"link", tryLink},
    Target{"plan", tryPlan}, Target{"scene", tryScene},     Target{"sgraph", trySgraph},
};

}  // namespace stridegraph::fuzz
