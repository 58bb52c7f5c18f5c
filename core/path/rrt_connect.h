#pragma once

#include "path/path_planner.h"
#include "path/sampled_path.h"

namespace stridegraph {

/// Plans by two trees that grow from start and goal towards samples and towards each other (section 4.1.2;
/// Kuffner and LaValle 2000, RRT-Connect). Every second sample of a tree is drawn near the tree itself
/// instead of anywhere. Both ends must be free.
SampledPath planByTrees(const FloorPlan& plan, const Vec2& start, const Vec2& goal, Random& random,
                        const PathParams& params);

}  // namespace stridegraph
