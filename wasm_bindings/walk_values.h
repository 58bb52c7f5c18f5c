#pragma once

#include <emscripten/val.h>

#include "graph/library.h"
#include "walk/plan.h"

namespace stridegraph::bindings {

/// The skeleton, the BVH layout and the body as plain values, so that a walk outlives the library it came
/// from: {joints: [{name, parent, isEndSite, offset}], channels, endSiteNames, unitsPerMetre, up, body:
/// {standing, parts, lift (metres)}}. Parent is -1 for the root; channels are numbers of BvhChannel; standing
/// is a Float64Array of root position (x, y, z) and rotations (w, x, y, z), parts one of 10 numbers for each
/// part of the body: of either end joint, offset and radius.
emscripten::val skeletonValue(const MotionLibrary& library);

/// An array of Joint of stridegraph.d.ts.
emscripten::val jointValues(const Skeleton& skeleton);

/// A plan as plain values: {status, report (JSON text), fps, frames, rootPositions (Float64Array, frames x
/// 3), rotations (Float64Array, frames x joints x w, x, y, z), positions (Float32Array, frames x joints x 3,
/// world, metres), blended (Uint8Array), contacts (Uint8Array), path, subgoals, roadmap (Float32Array of x,
/// z)}.
emscripten::val planValue(const Skeleton& skeleton, const Plan& plan);

/// {value: text} of a walk made by skeletonValue and planValue.
emscripten::val walkToBvh(const emscripten::val& skeleton, const emscripten::val& walk);

/// {value: Uint8Array} of a list of such walks, one or more, each with its `walker`, counted from 0.
emscripten::val walksToGlb(const emscripten::val& skeleton, const emscripten::val& walks);

}  // namespace stridegraph::bindings
