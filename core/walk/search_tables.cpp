#include "walk/search_tables.h"

namespace stridegraph {

SearchTables::SearchTables(const MotionLibrary& library, const MotionLimits& limits)
    : graph(library, limits),
      arrivals(graph, WalkCost{}, library.frames.framesPerSecond, {}),
      steering(graph, WalkCost{}, library.frames.framesPerSecond) {}

}  // namespace stridegraph
