#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace stridegraph {

/// Colours of bodies as 0xrrggbb (sRGB): of the first walker, and of further ones, over and over.
inline constexpr std::uint32_t kBodyColour = 0xe88a5a;
inline constexpr std::array<std::uint32_t, 8> kFurtherBodyColours = {0x3f7fd6, 0x7a5cc9, 0x1f9aa0, 0xc2557f,
                                                                     0x6f9a2e, 0xb07a2a, 0x4f5d9e, 0x8b4a9c};

/// A walker's, counted from 0.
inline constexpr std::uint32_t bodyColour(std::size_t walker) {
  return walker == 0 ? kBodyColour : kFurtherBodyColours[(walker - 1) % kFurtherBodyColours.size()];
}

}  // namespace stridegraph
