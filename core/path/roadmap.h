#pragma once

#include "path/distance_field.h"
#include "path/path_planner.h"
#include "path/sampled_path.h"

namespace stridegraph {

/// Plans by a probabilistic roadmap (section 4.1.1; Kavraki et al. 1996): seeded nodes in free places, edges
/// to the nearest ones in sight, start and goal joined to the nearest nodes that they see, A*. Edges are only
/// looked at where the search comes by (lazy PRM, Bohlin and Kavraki 2000), and only those are handed back.
/// When the roadmap misses the way it grows, up to params.growths times, half of the new nodes near the
/// smaller of the parts that hold start and goal. Both ends must be free.
SampledPath planByRoadmap(const FloorPlan& plan, const Vec2& start, const Vec2& goal, Random& random,
                          const PathParams& params);

/// Plans by a roadmap whose nodes are drawn around the cells that a distance field leads over from the start
/// to its goal, the more of them the nearer (sampling guided by the workspace: Kurniawati and Hsu 2004); A*
/// with the field as cost-to-go. So few nodes find the way that the size of the room does not matter; where
/// they miss it, more are drawn around the place where the search came to a halt, up to twenty times. The
/// start must be free. No path where the distance there is infinite, or when all that was in vain.
SampledPath planAlongField(const FloorPlan& plan, const Vec2& start, const DistanceField& field,
                           Random& random);

}  // namespace stridegraph
