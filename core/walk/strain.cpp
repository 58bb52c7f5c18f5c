#include "walk/strain.h"

#include <algorithm>
#include <cmath>

#include "graph/jerks.h"

namespace stridegraph {
namespace {

constexpr double kStep = 1.0 / 64.0;

}  // namespace

MotionLimits capturedLimits(const MotionLibrary& library) {
  std::vector<ClipSpan> captured;
  for (const LibraryClip& clip : library.clips) {
    if (clip.mirrored || clip.frameCount == 0) continue;
    captured.push_back(
        {&library.frames, clip.firstFrame, std::size_t{clip.firstFrame} + clip.frameCount - 1});
  }
  return motionLimits(captured.empty() ? clipSpans(library) : captured);
}

std::vector<float> frameStrains(const MotionLibrary& library, const MotionLimits& limits) {
  std::vector<float> strains(library.frames.frameCount(), 0.0F);
  for (const ClipSpan& span : clipSpans(library)) {
    visitRatios(limits, span, kDrivenRatio, [&](std::size_t frame, double ratio) {
      const double strain = std::round((ratio - kDrivenRatio) / kStep) * kStep;
      strains[frame] = std::max(strains[frame], static_cast<float>(strain));
    });
  }
  return strains;
}

}  // namespace stridegraph
