#include "walk/source_figures.h"

#include <algorithm>
#include <limits>

#include "walk/walk_measures.h"

namespace stridegraph {

SourceFigures sourceFigures(const MotionLibrary& library) {
  std::vector<ClipSpan> spans;
  for (const LibraryClip& clip : library.clips) {
    if (clip.frameCount == 0) continue;
    spans.push_back({&library.frames, clip.firstFrame, std::size_t{clip.firstFrame} + clip.frameCount - 1});
  }
  SourceFigures figures;
  figures.limits = motionLimits(spans);
  figures.footFloorsMetres.assign(library.contactJoints.size(), std::numeric_limits<double>::infinity());
  for (const ClipSpan& span : spans) {
    const FootPaths paths = footPaths(library.skeleton, span, library.contactJoints);
    figures.footSkateCmPerSecond +=
        footSkate(paths, library.frames.framesPerSecond) / static_cast<double>(spans.size());
    const std::vector<double> floors = footFloors(paths);
    for (std::size_t k = 0; k < floors.size(); ++k)
      figures.footFloorsMetres[k] = std::min(figures.footFloorsMetres[k], floors[k]);
  }
  return figures;
}

}  // namespace stridegraph
