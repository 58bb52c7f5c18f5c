#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "motion/body_colours.h"

namespace stridegraph {

/// A colour as written in design tools (sRGB) with its opacity.
struct Colour {
  float red = 0.0F, green = 0.0F, blue = 0.0F, alpha = 1.0F;

  static constexpr Colour hex(std::uint32_t rgb, float alpha = 1.0F) {
    return {static_cast<float>((rgb >> 16) & 0xff) / 255.0F, static_cast<float>((rgb >> 8) & 0xff) / 255.0F,
            static_cast<float>(rgb & 0xff) / 255.0F, alpha};
  }
  constexpr Colour faded(float factor) const { return {red, green, blue, alpha * factor}; }
};

/// Every colour of one appearance.
struct Palette {
  Colour horizon, zenith;           ///< Background; the floor fades into the horizon.
  Colour floor, outside, gridLine;  ///< Inside the room, outside of it, and the metre lines.
  Colour block, movingBlock, chosenBlock, wall;
  Colour body, blendedBody;
  Colour path, trail, subgoal, roadmap, leftFoot, rightFoot, start, goal;
  Colour track, avoid, prefer;    ///< Of moving blocks; of areas.
  std::array<Colour, 8> walkers;  ///< Of further walkers, over and over.
  Colour sun, sky;                ///< Light, linear factors rather than surface colours.
  Colour accent, panel, panelEdge, control, text, quietText, problem, good;
};

inline constexpr std::array<Colour, 8> coloursOf(const std::array<std::uint32_t, 8>& rgb) {
  std::array<Colour, 8> colours;
  for (std::size_t i = 0; i < rgb.size(); ++i) colours[i] = Colour::hex(rgb[i]);
  return colours;
}

inline constexpr Palette kLightPalette = {
    .horizon = Colour::hex(0xe9edf2),
    .zenith = Colour::hex(0xc9d6e6),
    .floor = Colour::hex(0xf4f3ef),
    .outside = Colour::hex(0xdfe3e8),
    .gridLine = Colour::hex(0x5a6b80, 0.20F),
    .block = Colour::hex(0x8fa1b8),
    .movingBlock = Colour::hex(0xd9a441),
    .chosenBlock = Colour::hex(0x5b8def),
    .wall = Colour::hex(0xc5cdd8),
    .body = Colour::hex(kBodyColour),
    .blendedBody = Colour::hex(0x7c6bd6),
    .path = Colour::hex(0x2f6fed, 0.95F),
    .trail = Colour::hex(0xe0662f, 0.9F),
    .subgoal = Colour::hex(0x2f6fed),
    .roadmap = Colour::hex(0x4a6078, 0.15F),
    .leftFoot = Colour::hex(0x1f8a8a, 0.75F),
    .rightFoot = Colour::hex(0xb04a78, 0.75F),
    .start = Colour::hex(0x1f9d6b),
    .goal = Colour::hex(0xd8404f),
    .track = Colour::hex(0xb07a14, 0.85F),
    .avoid = Colour::hex(0xe07b39),
    .prefer = Colour::hex(0x2fa36b),
    .walkers = coloursOf(kFurtherBodyColours),
    .sun = {1.02F, 0.96F, 0.86F, 1.0F},
    .sky = {0.36F, 0.40F, 0.46F, 1.0F},
    .accent = Colour::hex(0x2563d9),
    .panel = Colour::hex(0xffffff, 0.93F),
    .panelEdge = Colour::hex(0x1c2b40, 0.10F),
    .control = Colour::hex(0x1c2b40, 0.065F),
    .text = Colour::hex(0x1a2433),
    .quietText = Colour::hex(0x5b6778),
    .problem = Colour::hex(0xc4303f),
    .good = Colour::hex(0x15805a),
};

inline constexpr Palette kDarkPalette = {
    .horizon = Colour::hex(0x161a21),
    .zenith = Colour::hex(0x0e1116),
    .floor = Colour::hex(0x343b47),
    .outside = Colour::hex(0x1d222b),
    .gridLine = Colour::hex(0xb8c8e0, 0.13F),
    .block = Colour::hex(0x66758c),
    .movingBlock = Colour::hex(0xb98b36),
    .chosenBlock = Colour::hex(0x5b8def),
    .wall = Colour::hex(0x48536a),
    .body = Colour::hex(0xf0a070),
    .blendedBody = Colour::hex(0xa99bf5),
    .path = Colour::hex(0x6aa5ff, 0.95F),
    .trail = Colour::hex(0xffa163, 0.9F),
    .subgoal = Colour::hex(0x8bb8ff),
    .roadmap = Colour::hex(0xa8bddb, 0.12F),
    .leftFoot = Colour::hex(0x5fd6d0, 0.75F),
    .rightFoot = Colour::hex(0xf08bb8, 0.75F),
    .start = Colour::hex(0x3ecf95),
    .goal = Colour::hex(0xff6b78),
    .track = Colour::hex(0xe0b15a, 0.85F),
    .avoid = Colour::hex(0xf0925a),
    .prefer = Colour::hex(0x4fc98f),
    .walkers = {{Colour::hex(0x74aaf5), Colour::hex(0xa48df0), Colour::hex(0x55c8cc), Colour::hex(0xe886ad),
                 Colour::hex(0xa3cc5c), Colour::hex(0xdcaa5e), Colour::hex(0x8d9be0), Colour::hex(0xc184d4)}},
    .sun = {0.95F, 0.92F, 0.86F, 1.0F},
    .sky = {0.30F, 0.34F, 0.42F, 1.0F},
    .accent = Colour::hex(0x6aa5ff),
    .panel = Colour::hex(0x1b2029, 0.93F),
    .panelEdge = Colour::hex(0xffffff, 0.09F),
    .control = Colour::hex(0xffffff, 0.075F),
    .text = Colour::hex(0xe8edf5),
    .quietText = Colour::hex(0x9aa7b9),
    .problem = Colour::hex(0xff7b86),
    .good = Colour::hex(0x55d6a0),
};

/// The colour of a further walker's marks and body, 1 for the first of them.
inline const Colour& walkerColour(const Palette& palette, std::size_t walker) {
  return palette.walkers.at((walker - 1) % palette.walkers.size());
}

inline const Palette& paletteFor(bool dark) {
  return dark ? kDarkPalette : kLightPalette;
}

}  // namespace stridegraph
