#include "motion/facing.h"

#include "math/rotation.h"

namespace stridegraph {

Heading facingOffset(std::span<const Clip> clips, const FacingParams& params) {
  Vec2 sum = Vec2::Zero();
  for (const Clip& clip : clips) {
    const double minimumStepMetres = params.minimumSpeedMetresPerSecond / clip.framesPerSecond;
    for (std::size_t f = 0; f + 1 < clip.frameCount(); ++f) {
      const Vec2 step = onFloor(clip.rootPositions[f + 1]) - onFloor(clip.rootPositions[f]);
      if (step.norm() <= minimumStepMetres) continue;
      const Heading root = separateHeading(clip.pose(f).rotations[0]).heading;
      sum += (root - Heading::alongDirection(step)).direction();
    }
  }
  return Heading::alongDirection(sum);
}

}  // namespace stridegraph
