#pragma once

#include <memory>

#include "base/check.h"
#include "graph/library_builder.h"
#include "motion/gait_library.h"
#include "motion/gait_skeleton.h"
#include "walk/walk_planner.h"

namespace stridegraph::testing {

/// A planner with the clips that the page opens with, built once for all tests of a program.
inline std::shared_ptr<const WalkPlanner> sharedGaitPlanner() {
  static const std::shared_ptr<const WalkPlanner> planner = [] {
    std::vector<BvhDocument> clips;
    for (Clip& clip : defaultGaitClips())
      clips.push_back({gaitSkeleton(), gaitBvhLayout(), std::move(clip), {}});
    LibraryParams params;
    params.thresholdMetres = 0.03;
    params.neighbourFrames = 18;
    auto builder = LibraryBuilder::start(std::move(clips), params);
    STRIDEGRAPH_CHECK(builder.has_value());
    while (builder->step()) {
    }
    auto library = builder->finish();
    STRIDEGRAPH_CHECK(library.has_value());
    return std::make_shared<const WalkPlanner>(std::make_shared<const MotionLibrary>(std::move(*library)));
  }();
  return planner;
}

inline const WalkPlanner& gaitPlanner() {
  return *sharedGaitPlanner();
}

}  // namespace stridegraph::testing
