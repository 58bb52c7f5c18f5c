#include "figures/library_clips.h"

#include <algorithm>

#include "motion/transition_blend.h"

namespace stridegraph::figures {

Clip clipOf(const MotionLibrary& library, const LibraryClip& clip) {
  Clip copy{.name = clip.name,
            .framesPerSecond = library.frames.framesPerSecond,
            .jointCount = library.frames.jointCount,
            .rootPositions = {},
            .rotations = {}};
  for (std::size_t f = 0; f < clip.frameCount; ++f) copy.append(library.frames.pose(clip.firstFrame + f));
  return copy;
}

std::optional<Clip> clipNamed(const MotionLibrary& library, std::string_view name) {
  for (const LibraryClip& clip : library.clips) {
    if (clip.name == name) return clipOf(library, clip);
  }
  return std::nullopt;
}

ClipManner mannerOf(const Clip& clip) {
  ClipManner manner;
  double length = 0.0;
  for (std::size_t f = 0; f + 1 < clip.frameCount(); ++f) {
    const FloorTransform here = rootPlacement(clip.pose(f));
    const FloorTransform next = rootPlacement(clip.pose(f + 1));
    length += (next.translation - here.translation).norm();
    manner.turn = manner.turn + (next.heading - here.heading).angle();
  }
  if (clip.frameCount() > 1)
    manner.speedMetresPerSecond = length * clip.framesPerSecond / static_cast<double>(clip.frameCount() - 1);
  return manner;
}

std::vector<LibraryClip> clipsByLength(const MotionLibrary& library) {
  std::vector<LibraryClip> clips;
  for (const LibraryClip& clip : library.clips) {
    if (!clip.mirrored) clips.push_back(clip);
  }
  std::stable_sort(clips.begin(), clips.end(),
                   [](const LibraryClip& a, const LibraryClip& b) { return a.frameCount > b.frameCount; });
  return clips;
}

}  // namespace stridegraph::figures
