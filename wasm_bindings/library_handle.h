#pragma once

#include <emscripten/val.h>

#include <memory>
#include <string>

#include "graph/library.h"
#include "session.h"

namespace stridegraph::bindings {

/// A library on the WebAssembly heap: the one kind of object that JavaScript holds on to and has to delete.
class LibraryHandle {
 public:
  explicit LibraryHandle(MotionLibrary library);

  /// {value: Library} from .sgraph bytes, a Uint8Array.
  static emscripten::val open(const emscripten::val& bytes);

  /// {value: PlanHandle}. The scene is JSON text.
  emscripten::val startPlan(const emscripten::val& scene, const emscripten::val& options);
  /// The same for the last walk that arrived, which shows that second and goes on in the scene as it is now.
  emscripten::val startReplan(const emscripten::val& scene, double atSeconds, const emscripten::val& options);
  /// Figures and names, see LibraryInfo in stridegraph.d.ts.
  emscripten::val info() const;
  /// See skeletonValue.
  emscripten::val skeleton() const;
  /// See warningList.
  emscripten::val notes() const;
  /// .sgraph bytes as a Uint8Array.
  emscripten::val toBytes() const;

 private:
  const MotionLibrary& library() const { return session_->planner.library(); }
  emscripten::val answer(Result<AnytimePlan> plan);

  std::shared_ptr<Session> session_;
};

}  // namespace stridegraph::bindings
