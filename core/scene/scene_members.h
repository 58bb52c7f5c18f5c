#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace stridegraph {

/// Members of a scene's JSON object that this version knows; all others are kept as they are.
inline bool isKnownSceneMember(std::string_view name) {
  constexpr std::array<std::string_view, 12> kKnown = {"version",   "name",   "width",   "depth",
                                                       "obstacles", "moving", "start",   "goal",
                                                       "radius",    "seed",   "walkers", "constraints"};
  return std::find(kKnown.begin(), kKnown.end(), name) != kKnown.end();
}

}  // namespace stridegraph
