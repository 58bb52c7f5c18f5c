#include "graph/survival.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "graph/pose_distance.h"

namespace stridegraph {
namespace {

/// How a clip takes part in the transitions before pruning.
struct Links {
  std::size_t transitions = 0;
  bool leadsOut = false;
  bool leadsIn = false;
};

std::vector<Links> linksOf(const MotionLibrary& library, std::span<const FrameTransition> transitions) {
  std::vector<Links> links(library.clips.size());
  const auto linksAt = [&](FrameIndex frame) -> Links& {
    return links[static_cast<std::size_t>(&library.clipOf(frame) - library.clips.data())];
  };
  for (const FrameTransition& transition : transitions) {
    Links& source = linksAt(transition.from);
    Links& target = linksAt(transition.to);
    ++source.transitions;
    source.leadsOut = true;
    if (&target != &source) ++target.transitions;
    target.leadsIn = true;
  }
  return links;
}

/// First and last frame of a clip, within it, that pruning leaves: always one run, since a piece of a clip
/// between two nodes of a strongly connected part belongs to it.
struct Run {
  std::uint32_t first;
  std::uint32_t last;
};

std::vector<std::optional<Run>> prunedRuns(const MotionLibrary& library, const MotionGraph& pruned) {
  std::vector<std::optional<Run>> runs(library.clips.size());
  for (const FrameIndex node : pruned.nodes) {
    const LibraryClip& clip = library.clipOf(node);
    std::optional<Run>& run = runs[static_cast<std::size_t>(&clip - library.clips.data())];
    const std::uint32_t frame = node.value - clip.firstFrame;
    if (!run) run = Run{frame, frame};
    run->last = frame;
  }
  return runs;
}

/// For each clip how many of its frames the library's graph shows.
std::vector<std::size_t> survivingFrames(const MotionLibrary& library) {
  std::vector<std::size_t> frames(library.clips.size(), 0);
  const MotionGraph& graph = library.graph;
  const auto framesAt = [&](FrameIndex frame) -> std::size_t& {
    return frames[static_cast<std::size_t>(&library.clipOf(frame) - library.clips.data())];
  };
  for (const FrameIndex node : graph.nodes) ++framesAt(node);
  for (const MotionEdge& edge : graph.edges) {
    // Its ends are nodes.
    if (edge.kind == EdgeKind::kClipPiece) framesAt(graph.nodes[edge.from.value]) += edge.frames - 1;
  }
  return frames;
}

std::string reasonForNothing(const MotionLibrary& library, const LibraryClip& clip, const Links& links) {
  const std::size_t needed = library.params.transitionFrames + 2 * kWindowReach;
  if (clip.frameCount < needed)
    return fmt::format("too short: {} frames, at least {} are needed for a transition of {}", clip.frameCount,
                       needed, library.params.transitionFrames);
  if (links.transitions == 0)
    return fmt::format("no {} frames of it come within {} m of any other motion",
                       library.params.transitionFrames, library.params.thresholdMetres);
  if (!links.leadsOut) return "no transition leads out of it";
  if (!links.leadsIn) return "no transition leads into it";
  return "no way leads from it to the rest of the graph and back";
}

std::string reasonForPart(const LibraryClip& clip, const Run& run, std::size_t survivingFrames) {
  std::string reason;
  if (run.first > 0) reason = fmt::format("no way leads into frames 0 to {}", run.first - 1);
  if (run.last + 1 < clip.frameCount) {
    reason += reason.empty() ? "" : ", and ";
    reason += fmt::format("none leads out of frames {} to {} again", run.last + 1, clip.frameCount - 1);
  }
  const std::size_t thinned = run.last - run.first + 1 - survivingFrames;
  if (thinned > 0) {
    reason += reason.empty() ? "" : "; ";
    reason += fmt::format("{} frames are left out, since others show as much", thinned);
  }
  return reason;
}

}  // namespace

std::vector<ClipFate> clipFates(const MotionLibrary& library, const MotionGraph& pruned,
                                std::span<const FrameTransition> transitions) {
  const std::vector<Links> links = linksOf(library, transitions);
  const std::vector<std::optional<Run>> runs = prunedRuns(library, pruned);
  const std::vector<std::size_t> surviving = survivingFrames(library);
  std::vector<ClipFate> fates;
  for (std::size_t c = 0; c < library.clips.size(); ++c) {
    const LibraryClip& clip = library.clips[c];
    fates.push_back(
        {clip.name, clip.frameCount, links[c].transitions, surviving[c],
         runs[c] ? reasonForPart(clip, *runs[c], surviving[c]) : reasonForNothing(library, clip, links[c])});
  }
  return fates;
}

}  // namespace stridegraph
