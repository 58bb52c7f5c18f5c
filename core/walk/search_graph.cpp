#include "walk/search_graph.h"

#include <limits>

#include "base/check.h"
#include "walk/piece_motion.h"

namespace stridegraph {
namespace {

constexpr std::uint32_t kNotADecision = std::numeric_limits<std::uint32_t>::max();

/// Only every second frame is offered as a first one: neighbours start walks that hardly differ.
constexpr std::uint32_t kStartStride = 2;

}  // namespace

struct SearchGraph::Builder {
  const MotionLibrary& library;
  SearchGraph& graph;
  std::vector<std::vector<FloorTransform>> tracks;
  std::vector<std::uint32_t> decisionOf;  ///< Library node -> decision node.
  std::vector<std::uint32_t> decisions;   ///< Decision node -> library node.

  void findDecisions() {
    const MotionGraph& motion = library.graph;
    decisionOf.assign(motion.nodes.size(), kNotADecision);
    for (std::size_t n = 0; n < motion.nodes.size(); ++n) {
      if (motion.firstEdge[n + 1] - motion.firstEdge[n] < 2) continue;
      decisionOf[n] = static_cast<std::uint32_t>(decisions.size());
      decisions.push_back(static_cast<std::uint32_t>(n));
    }
    if (!decisions.empty()) return;
    // A graph that is one loop offers no choice; its first node serves as the place where the loop closes.
    decisionOf[0] = 0;
    decisions.push_back(0);
  }

  /// Follows the graph from a position on an edge to the next decision.
  SearchEdge follow(std::uint32_t edgeIndex, std::uint32_t begin) {
    SearchEdge way;
    way.firstSample = static_cast<std::uint32_t>(graph.samples_.size());
    way.firstStep = static_cast<std::uint32_t>(graph.steps_.size());
    FloorTransform wayFromEdge = tracks[edgeIndex][begin].inverse();
    Vec2 before = Vec2::Zero();
    for (;;) {
      const MotionEdge& edge = library.graph.edges[edgeIndex];
      const std::vector<FloorTransform>& track = tracks[edgeIndex];
      for (std::uint32_t p = begin + 1; p <= edge.frames; ++p) {
        const Vec2 point = wayFromEdge * track[p].translation;
        way.lengthMetres += (point - before).norm();
        graph.samples_.push_back(point.cast<float>());
        before = point;
      }
      graph.steps_.push_back({pieceOf(library.graph, edge), begin, edge.frames});
      if (edge.kind == EdgeKind::kTransition) {
        ++way.transitions;
        way.transitionDistanceMetres += static_cast<double>(edge.distanceMetres);
      }
      way.end = wayFromEdge * track[edge.frames];
      if (decisionOf[edge.to.value] != kNotADecision) {
        way.to = decisionOf[edge.to.value];
        break;
      }
      wayFromEdge = way.end;
      edgeIndex = library.graph.firstEdge[edge.to.value];
      begin = 0;
    }
    way.sampleCount = static_cast<std::uint32_t>(graph.samples_.size()) - way.firstSample;
    way.stepCount = static_cast<std::uint32_t>(graph.steps_.size()) - way.firstStep;
    return way;
  }

  void build() {
    const MotionGraph& motion = library.graph;
    STRIDEGRAPH_CHECK(!motion.nodes.empty());
    tracks.reserve(motion.edges.size());
    for (const MotionEdge& edge : motion.edges) tracks.push_back(pieceTrack(library, pieceOf(motion, edge)));
    for (const std::vector<FloorTransform>& track : tracks) graph.ends_.push_back(track.back());
    findDecisions();
    for (const std::uint32_t node : decisions) {
      graph.firstEdge_.push_back(static_cast<std::uint32_t>(graph.edges_.size()));
      for (std::uint32_t e = motion.firstEdge[node]; e < motion.firstEdge[node + 1]; ++e) {
        graph.edges_.push_back(follow(e, 0));
      }
    }
    graph.firstEdge_.push_back(static_cast<std::uint32_t>(graph.edges_.size()));
    for (std::uint32_t e = 0; e < motion.edges.size(); ++e) {
      if (motion.edges[e].kind != EdgeKind::kClipPiece) continue;
      for (std::uint32_t p = 0; p < motion.edges[e].frames; p += kStartStride) {
        graph.starts_.push_back(follow(e, p));
      }
    }
  }
};

SearchGraph::SearchGraph(const MotionLibrary& library) {
  Builder{library, *this, {}, {}, {}}.build();
}

std::span<const SearchEdge> SearchGraph::edgesFrom(std::size_t node) const {
  return std::span(edges_).subspan(firstEdge_[node], firstEdge_[node + 1] - firstEdge_[node]);
}

std::span<const Eigen::Vector2f> SearchGraph::samplesOf(const SearchEdge& edge) const {
  return std::span(samples_).subspan(edge.firstSample, edge.sampleCount);
}

std::span<const WalkStep> SearchGraph::stepsOf(const SearchEdge& edge) const {
  return std::span(steps_).subspan(edge.firstStep, edge.stepCount);
}

}  // namespace stridegraph
