#include "graph/library_connection.h"

#include <fmt/format.h>

#include <cmath>

#include "graph/region_transitions.h"
#include "graph/survival.h"
#include "graph/thinning.h"

namespace stridegraph {
namespace {

/// Stretches to choose from in a graph that is too large, seconds: longer than a turn with its lead-in, so
/// that most bring a motion from beginning to end.
constexpr double kStretchSeconds = 4.0;

ThinningParams thinningOf(const LibraryParams& params) {
  return {.mostTransitions = params.mostTransitions,
          .stretchFrames = static_cast<std::uint32_t>(std::lround(kStretchSeconds * params.framesPerSecond))};
}

void count(const MotionLibrary& library, const MotionGraph& whole, BuildReport& report) {
  report.nodesBeforePruning = whole.nodes.size();
  report.clipPiecesBeforePruning = whole.clipPieceCount();
  report.transitionsBeforePruning = whole.transitionCount();
  report.nodes = library.graph.nodes.size();
  report.clipPieces = library.graph.clipPieceCount();
  report.transitions = library.graph.transitionCount();
  std::size_t surviving = 0;
  for (const ClipFate& fate : report.clips) surviving += fate.survivingFrames;
  const std::size_t all = library.frames.frameCount();
  report.survivingShare = static_cast<double>(surviving) / static_cast<double>(all);
  if (report.transitions == report.transitionsBeforeThinning) return;
  report.warnings.push_back(
      {fmt::format("{} of {} transitions are kept, and {} of {} frames: of motions that are there many "
                   "times the library holds some, so that it opens and walks soon",
                   report.transitions, report.transitionsBeforeThinning, surviving, all),
       {},
       WarningTopic::kGraph});
}

}  // namespace

Connection connectionOf(const MotionLibrary& library, std::span<const Jerk> jerks,
                        std::span<const AlikeRegion> regions) {
  Connection connection;
  connection.transitions = transitionsOf(regions);
  std::erase_if(connection.transitions, [&](const FrameTransition& one) { return blendsAcross(jerks, one); });
  connection.whole = buildGraph(steadyFrameCounts(library, jerks), connection.transitions);
  connection.pruned = largestStronglyConnectedPart(connection.whole);
  return connection;
}

void connectLibrary(MotionLibrary& library, std::span<const Jerk> jerks, BuildReport& report) {
  const Connection connection = connectionOf(library, jerks, library.regions);
  const MotionGraph& pruned = connection.pruned;
  report.transitionsBeforeThinning = pruned.transitionCount();
  library.graph = withoutPassThroughNodes(thinnedGraph(pruned, library.clips, thinningOf(library.params)));
  report.clips = clipFates(library, pruned, connection.transitions);
  count(library, connection.whole, report);
}

}  // namespace stridegraph
