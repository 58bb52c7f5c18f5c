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

  /// For each walker why it is refused, if it is. Bodies that begin nearer to each other than they may walk
  /// (twice the radius and Traffic's margin) are refused all, as is who begins within a moving obstacle. Of
  /// those whose goals are nearer to each other than bodies stand, less the goal radius, the first one may
  /// go. A sentence names all whom a walker is too near to, by their numbers, from 1.
  std::vector<std::optional<Refusal>> refusals(const std::vector<Beginner>& walkers) const;
};

}  // namespace stridegraph
