#pragma once

#include <emscripten/val.h>

#include <optional>
#include <utility>
#include <vector>

#include "graph/library_builder.h"
#include "options.h"

namespace stridegraph::bindings {

/// Builds a library from BVH files in small steps: every clip read is one, then those of LibraryBuilder.
class BuilderHandle {
 public:
  /// {value: LibraryBuilder}, or why the options will not do; see BuildOptions in stridegraph.d.ts. `base` is
  /// undefined, or the .sgraph bytes of the library to append to.
  static emscripten::val create(const emscripten::val& options, const emscripten::val& base);

  BuilderHandle(BuildOptions options, std::optional<MotionLibrary> base)
      : options_(std::move(options)), base_(std::move(base)) {}

  /// Reads one clip, given as readBvhClip takes it: {value: undefined} or its error.
  emscripten::val addClip(const emscripten::val& clip);
  /// Ends the reading: {value: undefined}, or why the clips make no library.
  emscripten::val start();
  bool step();
  double progress() const;
  /// BuildReport::framePairs so far.
  double framePairs() const;
  /// {value: {library, report}} once step() has said false.
  emscripten::val finish();

 private:
  BuildOptions options_;
  std::optional<MotionLibrary> base_;
  std::vector<BvhDocument> documents_;
  std::optional<LibraryBuilder> builder_;
};

}  // namespace stridegraph::bindings
