#pragma once

#include <emscripten/val.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "math/types.h"

namespace stridegraph::bindings {

/// Every call answers {value} or {error}: the coat in stridegraph.mjs unpacks the one and throws the other,
/// since this module is built without exceptions.
emscripten::val succeed(emscripten::val value);
emscripten::val refuse(const Error& error);

/// A JavaScript string as UTF-8. Lone surrogates, which JavaScript allows and UTF-8 does not, become U+FFFD;
/// embind would take the character after one for its other half.
std::string textFrom(const emscripten::val& text);

/// Text of core as a JavaScript string, whatever bytes a file left in it (toUtf8).
emscripten::val textValue(std::string_view text);

/// A copy as a typed array of its own, outside the WebAssembly heap, whose views die when memory grows.
template <typename T>
emscripten::val copyOut(std::span<const T> values) {
  const emscripten::val view(emscripten::typed_memory_view(values.size(), values.data()));
  return view.call<emscripten::val>("slice");
}

/// x and z of each point in turn, as a Float32Array.
emscripten::val floorPoints(std::span<const Vec2> points);

/// An array of {message, file, line, column, topic}.
emscripten::val warningList(const Warnings& warnings);

}  // namespace stridegraph::bindings
