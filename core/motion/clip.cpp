#include "motion/clip.h"

#include "base/check.h"

namespace stridegraph {

PoseView Clip::pose(std::size_t frame) const {
  STRIDEGRAPH_CHECK(frame < frameCount());
  return {rootPositions[frame], std::span(rotations).subspan(frame * jointCount, jointCount)};
}

std::span<Quat> Clip::rotationsOf(std::size_t frame) {
  STRIDEGRAPH_CHECK(frame < frameCount());
  return std::span(rotations).subspan(frame * jointCount, jointCount);
}

std::span<const Quat> Clip::rotationsOf(std::size_t frame) const {
  STRIDEGRAPH_CHECK(frame < frameCount());
  return std::span(rotations).subspan(frame * jointCount, jointCount);
}

void Clip::append(const PoseView& pose) {
  STRIDEGRAPH_CHECK(pose.rotations.size() == jointCount);
  rootPositions.push_back(pose.rootPosition);
  rotations.insert(rotations.end(), pose.rotations.begin(), pose.rotations.end());
}

ClipSpan wholeOf(const Clip& clip) {
  STRIDEGRAPH_CHECK(clip.frameCount() > 0);
  return {&clip, 0, clip.frameCount() - 1};
}

}  // namespace stridegraph
