#pragma once

#include "path/floor_plan.h"
#include "walk/plan.h"
#include "walk/source_figures.h"

namespace stridegraph {

/// A walk and all that it came from.
struct FinishedWalk {
  const MotionLibrary& library;
  const SearchGraph& graph;
  const SourceFigures& sources;
  const FloorPlan& floor;
  const Scene& scene;
  const Placement& goal;
  const PlanOptions& options;
  const MotionPath& motion;
  const Clip& walk;  ///< In the room, as it will be shown.
  Traffic& traffic;
};

/// Fills in what a report says of a walk that arrived: lengths, clearance, feet, joints, seams, both ends,
/// and in its explanation what is left to be wished for.
void measurePlan(const FinishedWalk& done, PlanReport& report);

}  // namespace stridegraph
