#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "math/random.h"
#include "math/types.h"
#include "path/floor_plan.h"

namespace stridegraph {

/// What a sampling planner hands back.
struct SampledPath {
  std::vector<Vec2> path;                    ///< Empty when the planner missed the way.
  std::vector<std::pair<Vec2, Vec2>> edges;  ///< Of its roadmap or trees.
};

/// A place where the disc is free, uniformly; nothing when many tries found none.
inline std::optional<Vec2> sampleFree(const FloorPlan& plan, Random& random) {
  constexpr int kTries = 200;
  for (int i = 0; i < kTries; ++i) {
    const double x = random.uniform(0.0, plan.widthMetres());
    const Vec2 point(x, random.uniform(0.0, plan.depthMetres()));
    if (plan.isFree(point)) return point;
  }
  return std::nullopt;
}

}  // namespace stridegraph
