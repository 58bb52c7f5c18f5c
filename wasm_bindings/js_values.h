#pragma once

#include <emscripten/val.h>

#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "math/types.h"

namespace stridegraph::bindings {

/// Every call answers {value} or {error}: the coat in stridegraph.mjs unpacks the one and throws the other,
/// since this module is built without exceptions.
emscripten::val succeed(emscripten::val value);
emscripten::val refuse(const Error& error);

/// A copy as a typed array of its own, outside the WebAssembly heap, whose views die when memory grows.
template <typename T>
emscripten::val copyOut(std::span<const T> values) {
  const emscripten::val view(emscripten::typed_memory_view(values.size(), values.data()));
  return view.call<emscripten::val>("slice");
}

/// x and z of each point in turn, as a Float32Array.
emscripten::val floorPoints(std::span<const Vec2> points);

/// An array of {message, file, line, column}.
emscripten::val warningList(const Warnings& warnings);

}  // namespace stridegraph::bindings
