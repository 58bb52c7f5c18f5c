#include "graph/thinning.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "graph/graph_building.h"

namespace stridegraph {
namespace {

/// A stretch is represented as well as the frame before which this share of its frames lies.
constexpr std::size_t kLeastRepresentedShare = 10;

/// Frames of another stretch that a transition blends with this one's.
struct Alike {
  std::uint32_t stretch = 0;
  std::uint32_t firstFrame = 0;
  std::uint32_t lastFrame = 0;
};

struct Stretch {
  std::uint32_t firstFrame = 0;
  std::uint32_t frameCount = 0;
  std::size_t ownTransitions = 0;  ///< From the stretch to itself.
  std::vector<Alike> alike;        ///< An entry for each transition from or to another.
  std::uint32_t represented = 0;
  bool chosen = false;
};

class StretchChoice {
 public:
  StretchChoice(const MotionGraph& graph, std::span<const LibraryClip> clips, std::uint32_t stretchFrames)
      : graph_(graph) {
    for (const LibraryClip& clip : clips) cut(clip, stretchFrames);
    for (const MotionEdge& edge : graph.edges)
      if (edge.kind == EdgeKind::kTransition) link(edge);
    represented_.assign(stretchOf_.size(), 0);
  }

  void choose(std::size_t mostTransitions) {
    for (std::uint32_t s = 0; s < stretches_.size(); ++s) queue_.emplace(0U, s);
    for (std::size_t transitions = 0; !queue_.empty();) {
      const auto [represented, index] = queue_.top();
      queue_.pop();
      const Stretch& stretch = stretches_[index];
      if (stretch.chosen || stretch.represented != represented) continue;
      transitions += transitionsWith(stretch);
      if (transitions > mostTransitions) break;
      take(index);
    }
  }

  /// For each node whether it lies in a stretch that was chosen.
  std::vector<bool> chosenNodes() const {
    std::vector<bool> chosen;
    for (const FrameIndex node : graph_.nodes) chosen.push_back(stretches_[stretchOf_[node.value]].chosen);
    return chosen;
  }

 private:
  void cut(const LibraryClip& clip, std::uint32_t stretchFrames) {
    const std::uint32_t parts = std::max(1U, (clip.frameCount + stretchFrames / 2) / stretchFrames);
    for (std::uint32_t part = 0; part < parts; ++part) {
      const auto begin = static_cast<std::uint32_t>(std::uint64_t{clip.frameCount} * part / parts);
      const auto end = static_cast<std::uint32_t>(std::uint64_t{clip.frameCount} * (part + 1) / parts);
      stretchOf_.resize(clip.firstFrame + end, static_cast<std::uint32_t>(stretches_.size()));
      stretches_.push_back({clip.firstFrame + begin, end - begin, 0, {}, 0, false});
    }
  }

  void link(const MotionEdge& edge) {
    const std::uint32_t from = graph_.nodes[edge.from.value].value;
    const std::uint32_t to = graph_.nodes[edge.to.value].value;
    const std::uint32_t source = stretchOf_[from];
    const std::uint32_t target = stretchOf_[to];
    if (source == target) {
      ++stretches_[source].ownTransitions;
      return;
    }
    stretches_[source].alike.push_back({target, to - edge.targetSpan, to});
    stretches_[target].alike.push_back({source, from, from + edge.sourceSpan});
  }

  /// How many transitions come with a stretch.
  std::size_t transitionsWith(const Stretch& stretch) const {
    return stretch.ownTransitions + static_cast<std::size_t>(std::count_if(
                                        stretch.alike.begin(), stretch.alike.end(), [&](const Alike& alike) {
                                          return stretches_[alike.stretch].chosen;
                                        }));
  }

  void take(std::uint32_t index) {
    stretches_[index].chosen = true;
    std::vector<std::uint32_t> touched;
    for (const Alike& alike : stretches_[index].alike) {
      if (stretches_[alike.stretch].chosen) continue;
      for (std::uint32_t f = alike.firstFrame; f <= alike.lastFrame; ++f) ++represented_[f];
      touched.push_back(alike.stretch);
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    for (const std::uint32_t other : touched) {
      const std::uint32_t represented = leastRepresented(stretches_[other]);
      if (represented == stretches_[other].represented) continue;
      stretches_[other].represented = represented;
      queue_.emplace(represented, other);
    }
  }

  std::uint32_t leastRepresented(const Stretch& stretch) {
    const auto first = represented_.begin() + static_cast<std::ptrdiff_t>(stretch.firstFrame);
    ordered_.assign(first, first + static_cast<std::ptrdiff_t>(stretch.frameCount));
    const auto at =
        ordered_.begin() + static_cast<std::ptrdiff_t>(stretch.frameCount / kLeastRepresentedShare);
    std::nth_element(ordered_.begin(), at, ordered_.end());
    return *at;
  }

  using Entry = std::pair<std::uint32_t, std::uint32_t>;  ///< How well represented, and the stretch.

  const MotionGraph& graph_;
  std::vector<Stretch> stretches_;
  std::vector<std::uint32_t> stretchOf_;    ///< For each frame of the library.
  std::vector<std::uint32_t> represented_;  ///< For each frame of the library.
  std::vector<std::uint32_t> ordered_;      ///< Scratch.
  /// Least represented first; entries that are no longer true are skipped.
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace

MotionGraph thinnedGraph(const MotionGraph& graph, std::span<const LibraryClip> clips,
                         const ThinningParams& params) {
  if (graph.transitionCount() <= params.mostTransitions) return graph;
  StretchChoice choice(graph, clips, params.stretchFrames);
  choice.choose(params.mostTransitions);
  return largestStronglyConnectedPart(partOf(graph, choice.chosenNodes()));
}

}  // namespace stridegraph
