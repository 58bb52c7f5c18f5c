#include "walk/source_figures.h"

#include <algorithm>
#include <limits>

#include "graph/jerks.h"
#include "walk/strain.h"
#include "walk/walk_measures.h"

namespace stridegraph {

SourceFigures sourceFigures(const MotionLibrary& library) {
  const std::vector<ClipSpan> spans = clipSpans(library);
  SourceFigures figures;
  figures.limits = capturedLimits(library);
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
