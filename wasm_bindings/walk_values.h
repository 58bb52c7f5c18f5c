#pragma once

#include <emscripten/val.h>

#include "graph/library.h"
#include "walk/plan.h"

namespace stridegraph::bindings {

/// The skeleton and the BVH layout as plain values, so that a walk outlives the library it came from:
/// {joints: [{name, parent, isEndSite, offset, channels, endSiteName}], unitsPerMetre, up}. Parent is -1 for
/// the root; channels are numbers of BvhChannel.
emscripten::val skeletonValue(const Skeleton& skeleton, const BvhLayout& layout);

/// A plan as plain values: {status, report (JSON text), fps, frames, rootPositions (Float64Array, frames x
/// 3), rotations (Float64Array, frames x joints x w, x, y, z), positions (Float32Array, frames x joints x 3,
/// world, metres), blended (Uint8Array), contacts (Uint8Array), path, subgoals, roadmap (Float32Array of x,
/// z)}.
emscripten::val planValue(const Skeleton& skeleton, const Plan& plan);

/// {value: text} of a walk made by skeletonValue and planValue.
emscripten::val walkToBvh(const emscripten::val& skeleton, const emscripten::val& walk);

/// {value: Uint8Array} of a list of such walks, one or more.
emscripten::val walksToGlb(const emscripten::val& skeleton, const emscripten::val& walks);

}  // namespace stridegraph::bindings
