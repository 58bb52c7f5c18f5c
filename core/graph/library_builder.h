#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "graph/library.h"
#include "motion/bvh_reader.h"

namespace stridegraph {

/// What became of a clip.
struct ClipFate {
  std::string name;
  std::size_t frames = 0;
  std::size_t transitions = 0;      ///< Found between it and any clip before pruning.
  std::size_t survivingFrames = 0;  ///< Frames on edges of the library's graph.
  std::string reason;               ///< Why not all of it survives; empty when it does.
};

/// What building found, kept and dropped, and why.
struct BuildReport {
  std::size_t framePairs =
      0;  ///< Compared so far; pairs that an appended library knew already not among them.
  std::size_t nodesBeforePruning = 0, clipPiecesBeforePruning = 0, transitionsBeforePruning = 0;
  std::size_t nodes = 0, clipPieces = 0, transitions = 0;
  /// Transitions after pruning and before thinning: more than `transitions` where the library's limit
  /// (LibraryParams::mostTransitions) left some out.
  std::size_t transitionsBeforeThinning = 0;
  double survivingShare = 0.0;  ///< Of all frames.
  std::vector<ClipFate> clips;
  Warnings warnings;
};

/// Builds a library step by step, so that a caller may show progress, keep a page alive, or stop by not going
/// on.
class LibraryBuilder {
 public:
  /// Takes the clips in; refuses those that cannot make up one library, or are more than
  /// graph/library_limits.h allows, with the reason.
  static Result<LibraryBuilder> start(std::vector<BvhDocument> clips, const LibraryParams& params,
                                      std::string license = {});

  /// Goes on from a library: its clips, params and, unless another is given, its licence line stay. The
  /// result is the same, bit for bit, as of start() with the library's clips and then these; but only new
  /// frames are compared, with old and new ones. Where the mirror images of the library's clips change
  /// (ClipIntake), they are new, too.
  static Result<LibraryBuilder> append(MotionLibrary library, std::vector<BvhDocument> clips,
                                       std::string license = {});

  LibraryBuilder(LibraryBuilder&&) noexcept;
  LibraryBuilder& operator=(LibraryBuilder&&) noexcept;
  ~LibraryBuilder();

  /// Does a bounded piece of work (some milliseconds). False when nothing is left to do.
  bool step();
  /// Share done, 0..1.
  double progress() const;
  /// The library, once step() has said false; empties the builder.
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
