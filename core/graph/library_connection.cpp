#include "graph/library_connection.h"

#include <fmt/format.h>

#include <cmath>

#include "graph/graph_building.h"
#include "graph/region_transitions.h"
#include "graph/survival.h"
#include "graph/thinning.h"

namespace stridegraph {
namespace {

/// A strong part that holds less than this share of the frames is hardly a library.
constexpr double kTinyShare = 0.1;

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
  if (report.transitions < report.transitionsBeforeThinning) {
    report.warnings.push_back(
        {fmt::format("{} of {} transitions are kept, and {} of {} frames: of motions that are there many "
                     "times the library holds some, so that it opens and walks soon",
                     report.transitions, report.transitionsBeforeThinning, surviving, all),
         {}});
    return;
  }
  if (report.survivingShare >= kTinyShare || surviving == 0) return;
  report.warnings.push_back(
      {fmt::format(
           "only {} of {} frames are in the graph: walks can use next to nothing of these clips; more "
           "clips, a larger threshold, shorter transitions or mirroring may help",
           surviving, all),
       {}});
}

}  // namespace

Result<void> connectLibrary(MotionLibrary& library, std::span<const Jerk> jerks, BuildReport& report) {
  std::vector<FrameTransition> transitions = transitionsOf(library.regions);
  std::erase_if(transitions, [&](const FrameTransition& one) { return blendsAcross(jerks, one); });
  const MotionGraph whole = buildGraph(steadyFrameCounts(library, jerks), transitions);
  const MotionGraph pruned = largestStronglyConnectedPart(whole);
  report.transitionsBeforeThinning = pruned.transitionCount();
  library.graph = withoutPassThroughNodes(thinnedGraph(pruned, library.clips, thinningOf(library.params)));
  report.clips = clipFates(library, pruned, transitions);
  count(library, whole, report);
  if (!library.graph.nodes.empty()) return {};
  return fail(ErrorCode::kEmptyGraph,
              fmt::format("{} transitions were found within {} m, but no walk along them could go on for "
                          "ever; more clips, a larger threshold, shorter transitions or mirroring may help",
                          transitions.size(), library.params.thresholdMetres));
}

}  // namespace stridegraph
