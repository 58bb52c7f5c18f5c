#pragma once

#include "math/types.h"
#include "path/floor_plan.h"

namespace stridegraph {

/// Whether the disc can get from one free place to the other at all: decided, not searched for.
///
/// Grown rectangles and the half-planes beyond the walls are convex open sets. They part two places exactly
/// when some closed chain of overlapping sets goes round one place and not round the other: by the nerve
/// theorem every closed curve in the union can be bent into such a chain, and whether it parts the places is
/// a parity that adds up along the chain. A union-find that carries parities meets an odd chain, or there is
/// none. False when either place is not free.
bool isConnected(const FloorPlan& plan, const Vec2& from, const Vec2& to);

}  // namespace stridegraph
