#include "walk/standing.h"

#include <algorithm>
#include <cmath>

#include "motion/transition_blend.h"

namespace stridegraph {
namespace {

constexpr std::uint32_t kReach = 2;  ///< Frames looked at before and after.

}  // namespace

bool isStill(const Clip& clip, std::size_t first, std::size_t last, const StandingParams& params) {
  const double seconds = static_cast<double>(last - first) / clip.framesPerSecond;
  double way = 0.0;
  for (std::size_t f = first; f < last; ++f)
    way += (onFloor(clip.rootPositions[f + 1]) - onFloor(clip.rootPositions[f])).norm();
  const Heading turn = rootPlacement(clip.pose(last)).heading - rootPlacement(clip.pose(first)).heading;
  const Heading limit = Heading::fromAngle(params.turnPerSecond * seconds);
  return way <= params.slowMetresPerSecond * seconds && turn.cos > 0.0 && std::abs(turn.sin) <= limit.sin;
}

std::vector<Standing> standingFrames(const MotionLibrary& library, const StandingParams& params) {
  std::vector<Standing> standing(library.frames.frameCount(), Standing::kNo);
  for (const LibraryClip& clip : library.clips) {
    if (clip.frameCount < 2) continue;
    const std::uint32_t last = clip.firstFrame + clip.frameCount - 1;
    std::uint32_t stood = 0;
    for (std::uint32_t f = clip.firstFrame; f <= last; ++f) {
      const std::uint32_t from = std::max(clip.firstFrame + kReach, f) - kReach;
      const std::uint32_t to = std::min(last, f + kReach);
      stood = isStill(library.frames, from, to, params) ? stood + 1 : 0;
      // A clip that ends while the body stands shows all there is of it.
      if (stood > params.settleFrames || (stood > kReach && f == last)) {
        standing[f] = Standing::kSettled;
      } else if (stood > 0) {
        standing[f] = Standing::kYes;
      }
    }
  }
  return standing;
}

}  // namespace stridegraph
