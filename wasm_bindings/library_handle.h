#pragma once

#include <emscripten/val.h>

#include <string>

#include "graph/library.h"
#include "walk/plan.h"

namespace stridegraph::bindings {

/// A library on the WebAssembly heap: the one kind of object that JavaScript holds on to and has to delete.
class LibraryHandle {
 public:
  explicit LibraryHandle(MotionLibrary library);

  /// {value: Library} from .sgraph bytes, a Uint8Array.
  static emscripten::val open(const emscripten::val& bytes);

  /// {value: see planValue}. The scene is JSON text.
  emscripten::val plan(const std::string& scene, const emscripten::val& options) const;
  /// Figures and names, see LibraryInfo in stridegraph.d.ts.
  emscripten::val info() const;
  /// See skeletonValue.
  emscripten::val skeleton() const;
  /// .sgraph bytes as a Uint8Array.
  emscripten::val toBytes() const;

 private:
  WalkPlanner planner_;
};

}  // namespace stridegraph::bindings
