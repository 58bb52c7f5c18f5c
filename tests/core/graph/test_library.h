#pragma once

#include <vector>

#include "graph/library_builder.h"
#include "motion/test_motions.h"

namespace stridegraph::testing {

inline BvhDocument documentOf(Clip clip, std::string name) {
  clip.name = std::move(name);
  return {walker(), standardBvhLayout(walker()), std::move(clip), {}};
}

/// Walks of one gait that repeats itself: straight ahead and in both directions round.
inline std::vector<BvhDocument> threeWalks() {
  return {
      documentOf(walkOf({.frames = 80}), "ahead"),
      documentOf(walkOf({.frames = 80, .turnPerSecond = Angle::degrees(40)}), "left"),
      documentOf(walkOf({.frames = 80, .turnPerSecond = Angle::degrees(-40), .phaseCycles = 0.4}), "right")};
}

inline BuiltLibrary builtFrom(std::vector<BvhDocument> documents, const LibraryParams& params = {}) {
  return std::move(*buildLibrary(std::move(documents), params, "Made in code."));
}

}  // namespace stridegraph::testing
