#include "graph/turning_reach.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "motion/transition_blend.h"

namespace stridegraph {
namespace {

/// The turns of a library's edges, radians to the left.
class EdgeTurns {
 public:
  explicit EdgeTurns(const MotionLibrary& library)
      : library_(library), turned_(library.frames.frameCount(), 0.0) {
    const Clip& frames = library.frames;
    for (std::size_t f = 1; f < turned_.size(); ++f) {
      const Heading step = rootPlacement(frames.pose(f)).heading - rootPlacement(frames.pose(f - 1)).heading;
      turned_[f] = turned_[f - 1] + step.angle().radians();
    }
  }

  double of(const MotionEdge& edge) const {
    const MotionPiece piece = pieceOf(library_.graph, edge);
    if (piece.kind == EdgeKind::kClipPiece) return turned_[piece.to.value] - turned_[piece.from.value];
    // A blend turns as both of its sides do, half of the one and half of the other.
    const double source = turned_[piece.from.value + piece.sourceSpan] - turned_[piece.from.value];
    const double target = turned_[piece.to.value] - turned_[piece.to.value - piece.targetSpan];
    return 0.5 * static_cast<double>(piece.frames) * (source / piece.sourceSpan + target / piece.targetSpan);
  }

 private:
  const MotionLibrary& library_;
  std::vector<double> turned_;  ///< Up to each frame; across the borders of clips it means nothing.
};

/// The least mean of a weight per frame over all cycles of a strongly connected graph: from a cycle to one of
/// a lesser mean until there is none (Lawler 1976), each found as a cycle of negative weight by relaxing
/// edges (Bellman 1958, Ford 1956).
class LeastMeanCycle {
 public:
  LeastMeanCycle(const MotionGraph& graph, std::vector<double> weights)
      : graph_(graph), weights_(std::move(weights)), before_(graph.nodes.size(), kNone) {}

  /// Empty when it takes too long.
  std::optional<double> find() {
    double mean = meanOver(anyCycle());
    while (relaxations_ < kMostRelaxations) {
      const std::vector<std::size_t> cycle = cycleBelow(mean);
      if (cycle.empty()) return relaxations_ < kMostRelaxations ? std::optional(mean) : std::nullopt;
      const double lesser = meanOver(cycle);
      // Rounding may find a cycle again.
      if (!(lesser < mean)) return mean;
      mean = lesser;
    }
    return {};
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  static constexpr std::size_t kMostRelaxations = 10'000'000;
  static constexpr double kLeastGain = 1e-9;

  double meanOver(const std::vector<std::size_t>& cycle) const {
    double weight = 0.0;
    double frames = 0.0;
    for (const std::size_t e : cycle) {
      weight += weights_[e];
      frames += graph_.edges[e].frames;
    }
    return weight / frames;
  }

  /// Every node of the graph has an edge that leaves it.
  std::vector<std::size_t> anyCycle() {
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n) before_[n] = kNone;
    std::uint32_t node = 0;
    while (before_[node] == kNone) {
      before_[node] = graph_.firstEdge[node];
      node = graph_.edges[graph_.firstEdge[node]].to.value;
    }
    std::vector<std::size_t> cycle;
    const std::uint32_t start = node;
    do {
      cycle.push_back(graph_.firstEdge[node]);
      node = graph_.edges[graph_.firstEdge[node]].to.value;
    } while (node != start);
    return cycle;
  }

  std::vector<std::size_t> cycleBelow(double mean) {
    std::vector<double> distance(graph_.nodes.size(), 0.0);
    std::fill(before_.begin(), before_.end(), kNone);
    for (std::size_t pass = 0; pass < graph_.nodes.size() && relaxations_ < kMostRelaxations; ++pass) {
      bool changed = false;
      for (std::size_t e = 0; e < graph_.edges.size(); ++e) {
        const MotionEdge& edge = graph_.edges[e];
        const double through = distance[edge.from.value] + weights_[e] - mean * edge.frames;
        if (through >= distance[edge.to.value] - kLeastGain) continue;
        distance[edge.to.value] = through;
        before_[edge.to.value] = e;
        changed = true;
      }
      relaxations_ += graph_.edges.size();
      if (!changed) return {};
      std::vector<std::size_t> cycle = cycleAmongPredecessors();
      if (!cycle.empty()) return cycle;
    }
    return {};
  }

  /// A cycle of edges that nodes were last reached by has a negative weight.
  std::vector<std::size_t> cycleAmongPredecessors() const {
    constexpr std::uint32_t kUnseen = 0;
    std::vector<std::uint32_t> seenFrom(graph_.nodes.size(), kUnseen);
    for (std::uint32_t start = 0; start < graph_.nodes.size(); ++start) {
      std::uint32_t node = start;
      while (seenFrom[node] == kUnseen && before_[node] != kNone) {
        seenFrom[node] = start + 1;
        node = graph_.edges[before_[node]].from.value;
      }
      if (before_[node] == kNone || seenFrom[node] != start + 1) continue;
      std::vector<std::size_t> cycle;
      const std::uint32_t first = node;
      do {
        cycle.push_back(before_[node]);
        node = graph_.edges[before_[node]].from.value;
      } while (node != first);
      return cycle;
    }
    return {};
  }

  const MotionGraph& graph_;
  std::vector<double> weights_;
  std::vector<std::size_t> before_;  ///< Edge by which each node was last reached.
  std::size_t relaxations_ = 0;
};

}  // namespace

std::optional<TurningReach> turningReachOf(const MotionLibrary& library) {
  const EdgeTurns turns(library);
  std::vector<double> left;
  std::vector<double> right;
  for (const MotionEdge& edge : library.graph.edges) {
    left.push_back(turns.of(edge));
    right.push_back(-left.back());
  }
  const std::optional<double> least = LeastMeanCycle(library.graph, std::move(left)).find();
  const std::optional<double> most = LeastMeanCycle(library.graph, std::move(right)).find();
  if (!least || !most) return {};
  const double rate = library.frames.framesPerSecond;
  return TurningReach{Angle::radians(*least * rate), Angle::radians(-*most * rate)};
}

}  // namespace stridegraph
