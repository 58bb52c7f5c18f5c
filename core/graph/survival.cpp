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

/// First and last frame of a clip, within it, that the graph holds: always one run, since a piece of a clip
/// between two nodes of a strongly connected part belongs to it.
struct Run {
  std::uint32_t first;
  std::uint32_t last;
};

std::vector<std::optional<Run>> survivingRuns(const MotionLibrary& library) {
  std::vector<std::optional<Run>> runs(library.clips.size());
  for (const FrameIndex node : library.graph.nodes) {
    const LibraryClip& clip = library.clipOf(node);
    std::optional<Run>& run = runs[static_cast<std::size_t>(&clip - library.clips.data())];
    const std::uint32_t frame = node.value - clip.firstFrame;
    if (!run) run = Run{frame, frame};
    run->last = frame;
  }
  return runs;
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

std::string reasonForPart(const LibraryClip& clip, const Run& run) {
  std::string reason;
  if (run.first > 0) reason = fmt::format("no way leads into frames 0 to {}", run.first - 1);
  if (run.last + 1 < clip.frameCount) {
    reason += reason.empty() ? "" : ", and ";
    reason += fmt::format("none leads out of frames {} to {} again", run.last + 1, clip.frameCount - 1);
  }
  return reason;
}

}  // namespace

std::vector<ClipFate> clipFates(const MotionLibrary& library, std::span<const FrameTransition> transitions) {
  const std::vector<Links> links = linksOf(library, transitions);
  const std::vector<std::optional<Run>> runs = survivingRuns(library);
  std::vector<ClipFate> fates;
  for (std::size_t c = 0; c < library.clips.size(); ++c) {
    const LibraryClip& clip = library.clips[c];
    ClipFate fate{clip.name, clip.frameCount, links[c].transitions, 0, {}};
    if (runs[c]) {
      fate.survivingFrames = runs[c]->last - runs[c]->first + 1;
      fate.reason = reasonForPart(clip, *runs[c]);
    } else {
      fate.reason = reasonForNothing(library, clip, links[c]);
    }
    fates.push_back(std::move(fate));
  }
  return fates;
}

}  // namespace stridegraph
