#pragma once

#include <emscripten/val.h>

#include "base/result.h"
#include "motion/bvh_reader.h"

namespace stridegraph::bindings {

/// Reads a clip as the coat hands it over: {name, bytes (Uint8Array of the file), reading (its own units and
/// up)}. What `reading` leaves open is as in `otherwise`.
Result<BvhDocument> readBvhClip(const emscripten::val& clip, const BvhReadParams& otherwise);

/// {value: ClipInspection of stridegraph.d.ts} of such a clip, or why it cannot be read. `options` are
/// ReadingOptions.
emscripten::val inspectClip(const emscripten::val& clip, const emscripten::val& options);

}  // namespace stridegraph::bindings
