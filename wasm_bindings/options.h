#pragma once

#include <emscripten/val.h>

#include <string>

#include "base/result.h"
#include "graph/library.h"
#include "motion/bvh_reader.h"
#include "walk/plan.h"

namespace stridegraph::bindings {

/// PlanOptions of stridegraph.d.ts, without the clock. Fails with kInvalidArgument.
Result<PlanOptions> readPlanOptions(const emscripten::val& options);

/// ReadingOptions of stridegraph.d.ts, named `what` in messages. Fails with kInvalidArgument.
Result<BvhReadParams> readReadingOptions(const emscripten::val& options, const std::string& what);

/// BuildOptions of stridegraph.d.ts. `append` is left to the caller; beside it no setting of a library may be
/// given.
struct BuildOptions {
  LibraryParams library;
  BvhReadParams reading;
  std::string license;
};
Result<BuildOptions> readBuildOptions(const emscripten::val& options);

}  // namespace stridegraph::bindings
