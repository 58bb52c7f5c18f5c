#pragma once

#include <array>
#include <cstddef>

#include "graph/pose_distance.h"

namespace stridegraph {

/// Windows that begin at four frames in a row overlap: their sums share parts.
inline constexpr std::size_t kWindowsAtOnce = 4;
inline constexpr std::size_t kFramesOfWindows = kWindowsAtOnce + kWindowFrames - 1;

/// Sums of the numbers 0..4, 1..5, 2..6 and 3..7. Windows of one frame of a clip are always summed in the
/// same order when the first of the four begins at a multiple of kWindowsAtOnce.
inline __attribute__((always_inline)) std::array<float, kWindowsAtOnce> windowSums(
    const std::array<float, kFramesOfWindows>& numbers) {
  static_assert(kWindowsAtOnce == 4 && kWindowFrames == 5);
  const float middle = numbers[3] + numbers[4];
  const float early = (numbers[1] + numbers[2]) + middle;
  const float late = middle + (numbers[5] + numbers[6]);
  return {numbers[0] + early, early + numbers[5], numbers[2] + late, late + numbers[7]};
}

}  // namespace stridegraph
