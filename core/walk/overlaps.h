#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "walk/plan.h"

namespace stridegraph {

/// Why a walker cannot walk as a scene has it, told before any search.
struct Refusal {
  PlanStatus status = PlanStatus::kStartBlocked;  ///< Or kGoalBlocked.
  std::string explanation;
};

/// A walker, and whether its walk begins where the scene says: else it is under way.
struct Beginner {
  Walker walker;
  bool begins = true;
};

/// What the bodies of walkers and moving obstacles take from each other at the start and in the end. Radii in
/// metres.
struct Overlaps {
  const Scene& scene;
  double radiusMetres = 0.4;
  double goalRadiusMetres = 0.1;

  /// For each walker the reason why it is refused; empty for those that may go. Walkers that start nearer to
  /// each other than twice the radius and Traffic's margin are all refused, and so is a walker that starts
  /// within a moving obstacle. Of walkers whose goals overlap, less the goal radius, the first one may go. A
  /// reason names every walker that is too near, by its number from 1.
  std::vector<std::optional<Refusal>> refusals(const std::vector<Beginner>& walkers) const;
};

}  // namespace stridegraph
