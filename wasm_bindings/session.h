#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "walk/walk_planner.h"

namespace stridegraph::bindings {

/// What a library plans with, and what it has planned: shared with plans that are under way, which may
/// outlive the library's handle.
struct Session {
  explicit Session(MotionLibrary library)
      : planner(std::make_shared<const MotionLibrary>(std::move(library))) {}

  WalkPlanner planner;
  std::optional<Plan> underWay;  ///< The last plan that arrived.
};

}  // namespace stridegraph::bindings
