#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "graph/build_report.h"
#include "graph/library.h"
#include "motion/bvh_reader.h"

namespace stridegraph {

/// Builds a library step by step, so that a caller may show progress, keep a page alive, or stop by not going
/// on. The number of steps is finite whatever the clips: amounts are limited (library_limits.h).
class LibraryBuilder {
 public:
  /// Takes the clips in; refuses those that cannot make up one library, with the reason (clip_faults.h),
  /// or are more than library_limits.h allows.
  /// Texts that are not UTF-8 become so (toUtf8()). The report's warnings are kept as the library's notes.
  static Result<LibraryBuilder> start(std::vector<BvhDocument> clips, const LibraryParams& params,
                                      std::string license = {});

  /// Goes on from a library: its clips, params and, unless another is given, its licence line stay. The
  /// result is the same, bit for bit, as of start() with the library's clips and then these; but only new
  /// frames are compared, with old and new ones. Where the mirror images of the library's clips change
  /// (ClipIntake), they are new, too. Notes stay, but for those on the library as a whole, which are made
  /// anew.
  static Result<LibraryBuilder> append(MotionLibrary library, std::vector<BvhDocument> clips,
                                       std::string license = {});

  LibraryBuilder(LibraryBuilder&&) noexcept;
  LibraryBuilder& operator=(LibraryBuilder&&) noexcept;
  ~LibraryBuilder();

  /// Does a bounded piece of work (some milliseconds). False when nothing is left to do.
  bool step();
  /// Share done, 0..1. It never falls.
  double progress() const;
  /// The library, once step() has said false; empties the builder. Fails with kClipTooShort, or with
  /// kEmptyGraph and what would help, in figures (build_advice.h).
  Result<MotionLibrary> finish();
  const BuildReport& report() const;

 private:
  struct State;
  explicit LibraryBuilder(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// All steps at once.
struct BuiltLibrary {
  MotionLibrary library;
  BuildReport report;
};
Result<BuiltLibrary> buildLibrary(std::vector<BvhDocument> clips, const LibraryParams& params = {},
                                  std::string license = {});

}  // namespace stridegraph
