#pragma once

#include <optional>
#include <vector>

#include "math/types.h"
#include "path/floor_plan.h"

namespace stridegraph {

/// The shortest way of the disc.
struct ShortestPath {
  double lengthMetres = 0.0;  ///< Of the straight pieces and arcs, not of the polyline.
  std::vector<Vec2> points;  ///< From start to goal; outside the arcs by at most 1 mm. Every segment is free.
};

/// The exact shortest path: straight pieces tangent to the rounded corners of grown rectangles, and arcs
/// along these, found by A* over the tangents (the tangent visibility graph of Liu and Arimoto 1992), which
/// are only looked for from corners that the search reaches. Nothing when there is none or an end is not
/// free. Gaps narrower than the disc by up to 2 micrometres count as passable, as in FloorPlan.
std::optional<ShortestPath> shortestPath(const FloorPlan& plan, const Vec2& start, const Vec2& goal);

}  // namespace stridegraph
