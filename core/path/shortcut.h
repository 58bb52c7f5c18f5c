#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "math/random.h"
#include "math/types.h"
#include "path/floor_plan.h"

namespace stridegraph {

/// Cuts corners off a free path: first leaves out points that it does not need, then takes straight lines
/// between random places on it up to 30 m apart, where these are free, and at last leaves out again what can
/// be. Never longer than before; ends stay.
std::vector<Vec2> shortcut(const FloorPlan& plan, std::span<const Vec2> path, std::size_t rounds,
                           Random& random);

}  // namespace stridegraph
