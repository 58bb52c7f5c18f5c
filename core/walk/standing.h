#pragma once

#include <cstdint>
#include <vector>

#include "graph/library.h"

namespace stridegraph {

/// When a captured body counts as standing.
struct StandingParams {
  double slowMetresPerSecond = 0.15;         ///< The root over the floor, mean of 5 frames; people sway below
                                             ///< 0.05 and walk above 0.6.
  Angle turnPerSecond = Angle::degrees(20);  ///< Faster is turning on the spot.
  std::uint32_t settleFrames = 8;            ///< Stood so long, a walk may end: both feet have come to rest.
};

/// Whether a body stands through frames first..last of a clip: its root is slow and hardly turns. The frames
/// span less than a quarter of a second or so, or it might turn once around unnoticed.
bool isStill(const Clip& clip, std::size_t first, std::size_t last, const StandingParams& params = {});

enum class Standing : std::uint8_t {
  kNo,
  kYes,      ///< Stands.
  kSettled,  ///< Has stood for a while: a walk may end here.
};

/// For each frame of the library whether the body stands there. Looks at captured frames within their clip.
std::vector<Standing> standingFrames(const MotionLibrary& library, const StandingParams& params = {});

}  // namespace stridegraph
