#include "graph/library.h"

#include <algorithm>

#include "base/check.h"
#include "math/rotation.h"

namespace stridegraph {

FloorTransform MotionLibrary::placementAt(FrameIndex frame) const {
  const PoseView pose = frames.pose(frame.value);
  return {onFloor(pose.rootPosition), separateHeading(pose.rotations[0]).heading - facingOffset};
}

const LibraryClip& MotionLibrary::clipOf(FrameIndex frame) const {
  STRIDEGRAPH_CHECK(frame.value < frames.frameCount());
  const auto after =
      std::upper_bound(clips.begin(), clips.end(), frame.value,
                       [](std::uint32_t f, const LibraryClip& clip) { return f < clip.firstFrame; });
  return *(after - 1);
}

}  // namespace stridegraph
