#include "graph/survival.h"

#include <fmt/format.h>

#include <string>

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

using Runs = std::vector<PlayedRun>;

std::size_t framesOf(const Runs& runs) {
  std::size_t frames = 0;
  for (const PlayedRun& run : runs) frames += run.last - run.first + 1;
  return frames;
}

std::string reasonForNothing(const MotionLibrary& library, const LibraryClip& clip, const Links& links) {
  const std::size_t needed = library.params.transitionFrames + 2 * kWindowReach;
  if (clip.frameCount < needed)
    return fmt::format("too short: {} frames, at least {} are needed for a transition of {}", clip.frameCount,
                       needed, library.params.transitionFrames);
  if (links.transitions == 0)
    return fmt::format("no {} frames of it come within {} m of any other frames",
                       library.params.transitionFrames, library.params.thresholdMetres);
  if (!links.leadsOut) return "no transition leads out of it";
  if (!links.leadsIn) return "no transition leads into it";
  return "no transitions lead from it to the rest of the graph and back";
}

std::string reasonForPart(const LibraryClip& clip, const Runs& pruned, std::size_t survivingFrames) {
  std::vector<std::string> missing;
  if (pruned.front().first > 0)
    missing.push_back(fmt::format("into frames 0 to {}", pruned.front().first - 1));
  for (std::size_t r = 0; r + 1 < pruned.size(); ++r) {
    if (pruned[r].last + 1 < pruned[r + 1].first)
      missing.push_back(fmt::format("through frames {} to {}", pruned[r].last + 1, pruned[r + 1].first - 1));
  }
  if (pruned.back().last + 1 < clip.frameCount)
    missing.push_back(
        fmt::format("out of frames {} to {} again", pruned.back().last + 1, clip.frameCount - 1));
  std::string reason =
      missing.empty() ? "" : fmt::format("no transition leads {}", fmt::join(missing, " or "));
  if (survivingFrames < framesOf(pruned)) {
    reason += missing.empty() ? "" : "; ";
    reason += fmt::format("{} frames are left out, since other frames show the same motion",
                          framesOf(pruned) - survivingFrames);
  }
  return reason;
}

}  // namespace

std::vector<Runs> playedRuns(const MotionLibrary& library, const MotionGraph& graph) {
  std::vector<bool> playsOn(graph.nodes.size(), false);
  for (const MotionEdge& edge : graph.edges)
    if (edge.kind == EdgeKind::kClipPiece) playsOn[edge.from.value] = true;
  std::vector<Runs> runs(library.clips.size());
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    const LibraryClip& clip = library.clipOf(graph.nodes[n]);
    Runs& ofClip = runs[static_cast<std::size_t>(&clip - library.clips.data())];
    const std::uint32_t frame = graph.nodes[n].value - clip.firstFrame;
    // A piece of a clip leads to the next node.
    if (n == 0 || !playsOn[n - 1]) ofClip.push_back({frame, frame});
    ofClip.back().last = frame;
  }
  return runs;
}

std::size_t playedFrames(const MotionLibrary& library, const MotionGraph& graph) {
  std::size_t frames = 0;
  for (const Runs& runs : playedRuns(library, graph)) frames += framesOf(runs);
  return frames;
}

std::vector<ClipFate> clipFates(const MotionLibrary& library, const MotionGraph& pruned,
                                std::span<const FrameTransition> transitions) {
  const std::vector<Links> links = linksOf(library, transitions);
  const std::vector<Runs> prunedRuns = playedRuns(library, pruned);
  const std::vector<Runs> runs = playedRuns(library, library.graph);
  std::vector<ClipFate> fates;
  for (std::size_t c = 0; c < library.clips.size(); ++c) {
    const LibraryClip& clip = library.clips[c];
    const std::size_t frames = framesOf(runs[c]);
    fates.push_back({clip.name, clip.frameCount, links[c].transitions, frames,
                     prunedRuns[c].empty() ? reasonForNothing(library, clip, links[c])
                                           : reasonForPart(clip, prunedRuns[c], frames)});
  }
  return fates;
}

}  // namespace stridegraph
