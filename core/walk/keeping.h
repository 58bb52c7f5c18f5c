#pragma once

#include <cstddef>

#include "path/floor_plan.h"
#include "walk/plan.h"

namespace stridegraph {

/// Whether a walk under way was planned with options that ask for the same, but for how long to look.
bool askedAlike(const Plan& walk, const PlanOptions& options);

/// Whether a walk under way, as it goes on from a frame, touches nothing of an edited scene and leads where
/// that asks: the same goals, constraints and movers, and room for its disc all along.
/// `floor` is the scene's.
bool stillHolds(const Plan& walk, std::size_t frame, const Scene& scene, const FloorPlan& floor);

/// Whether every obstacle that the walk was planned around still stands where it stood: then no shorter way
/// can have opened.
bool nothingFreed(const Plan& walk, const Scene& scene);

/// What all walkers of a plan have still to go from a frame on, metres.
double metresLeft(const Plan& walk, std::size_t frame);

/// Whether all walkers of a plan arrive.
bool allArrive(const Plan& plan);

}  // namespace stridegraph
