#include "graph/library.h"

#include <algorithm>

#include "base/check.h"
#include "motion/transition_blend.h"

namespace stridegraph {

FloorTransform MotionLibrary::placementAt(FrameIndex frame) const {
  FloorTransform placement = rootPlacement(frames.pose(frame.value));
  placement.heading = placement.heading - facingOffset;
  return placement;
}

const LibraryClip& MotionLibrary::clipOf(FrameIndex frame) const {
  STRIDEGRAPH_CHECK(frame.value < frames.frameCount());
  const auto after =
      std::upper_bound(clips.begin(), clips.end(), frame.value,
                       [](std::uint32_t f, const LibraryClip& clip) { return f < clip.firstFrame; });
  return *(after - 1);
}

}  // namespace stridegraph
