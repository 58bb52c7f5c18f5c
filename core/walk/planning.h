#pragma once

#include "walk/plan.h"
#include "walk/traffic.h"

namespace stridegraph {

/// What is known of a library before any plan, and of paces after some.
struct Prepared {
  const MotionLibrary& library;
  const SearchTables& tables;
  const FootCleanup& feet;
  const SourceFigures& sources;
  PaceTables& paces;
};

/// One walker's part of a scene.
struct PlanTask {
  const FloorPlan& floor;
  Placement start;
  Placement goal;
  Traffic& traffic;
  const Plan* underWay =
      nullptr;  ///< A walk that is to go on differently from `frame` on; null for a new one.
  std::size_t frame = 0;
};

/// Plans one walk: path, motion, synthesis. Scene and options are in range. A walk under way stays frame by
/// frame as it is until `frame`, and a little longer: until it comes to the next decision node.
Plan planWalk(const Prepared& prepared, const Scene& scene, const PlanOptions& options, const PlanTask& task);

}  // namespace stridegraph
