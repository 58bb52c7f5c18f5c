#include "graph/graph_building.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include "base/check.h"

namespace stridegraph {
namespace {

NodeIndex nodeAt(const std::vector<FrameIndex>& nodes, FrameIndex frame) {
  const auto found = std::lower_bound(nodes.begin(), nodes.end(), frame);
  STRIDEGRAPH_CHECK(found != nodes.end() && *found == frame);
  return NodeIndex(static_cast<std::size_t>(found - nodes.begin()));
}

MotionEdge clipPiece(const std::vector<FrameIndex>& nodes, NodeIndex from, NodeIndex to) {
  MotionEdge piece;
  piece.from = from;
  piece.to = to;
  piece.frames = nodes[to.value].value - nodes[from.value].value;
  return piece;
}

/// Tarjan's depth-first search with a stack of its own.
class ComponentFinder {
 public:
  explicit ComponentFinder(const MotionGraph& graph)
      : graph_(graph),
        order_(graph.nodes.size(), kUnseen),
        low_(graph.nodes.size(), 0),
        component_(graph.nodes.size(), kUnseen) {}

  /// For each node the number of its component.
  std::vector<std::uint32_t> run() {
    for (std::uint32_t n = 0; n < graph_.nodes.size(); ++n) {
      if (order_[n] == kUnseen) visitFrom(n);
    }
    return std::move(component_);
  }

 private:
  static constexpr std::uint32_t kUnseen = 0xffffffffU;
  struct Visit {
    std::uint32_t node;
    std::uint32_t nextEdge;
  };

  void enter(std::uint32_t node) {
    order_[node] = low_[node] = entered_++;
    open_.push_back(node);
    visits_.push_back({node, graph_.firstEdge[node]});
  }

  void visitFrom(std::uint32_t start) {
    enter(start);
    while (!visits_.empty()) {
      Visit& visit = visits_.back();
      const std::uint32_t node = visit.node;
      if (visit.nextEdge < graph_.firstEdge[node + 1]) {
        const std::uint32_t next = graph_.edges[visit.nextEdge++].to.value;
        if (order_[next] == kUnseen) {
          enter(next);
        } else if (component_[next] == kUnseen) {
          low_[node] = std::min(low_[node], order_[next]);
        }
        continue;
      }
      visits_.pop_back();
      if (!visits_.empty()) {
        std::uint32_t& parentLow = low_[visits_.back().node];
        parentLow = std::min(parentLow, low_[node]);
      }
      if (low_[node] == order_[node]) closeComponent(node);
    }
  }

  void closeComponent(std::uint32_t root) {
    std::uint32_t node = kUnseen;
    do {
      node = open_.back();
      open_.pop_back();
      component_[node] = components_;
    } while (node != root);
    ++components_;
  }

  const MotionGraph& graph_;
  std::vector<std::uint32_t> order_, low_, component_;
  std::vector<std::uint32_t> open_;
  std::vector<Visit> visits_;
  std::uint32_t entered_ = 0;
  std::uint32_t components_ = 0;
};

}  // namespace

void indexEdges(MotionGraph& graph) {
  const auto key = [](const MotionEdge& edge) {
    return std::tuple(edge.from, edge.to, edge.kind, edge.frames, edge.sourceSpan, edge.targetSpan,
                      edge.distanceMetres);
  };
  std::sort(graph.edges.begin(), graph.edges.end(),
            [&](const MotionEdge& a, const MotionEdge& b) { return key(a) < key(b); });
  graph.firstEdge.assign(graph.nodes.size() + 1, 0);
  for (const MotionEdge& edge : graph.edges) ++graph.firstEdge[edge.from.value + 1];
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) graph.firstEdge[n + 1] += graph.firstEdge[n];
}

MotionGraph buildGraph(std::span<const std::uint32_t> clipFrameCounts,
                       std::span<const FrameTransition> transitions) {
  MotionGraph graph;
  std::vector<std::uint32_t> clipStarts;
  std::uint32_t frames = 0;
  for (const std::uint32_t count : clipFrameCounts) {
    clipStarts.push_back(frames);
    if (count > 0) {
      graph.nodes.emplace_back(std::size_t{frames});
      graph.nodes.emplace_back(std::size_t{frames} + count - 1);
    }
    frames += count;
  }
  for (const FrameTransition& transition : transitions) {
    STRIDEGRAPH_CHECK(transition.from.value < frames && transition.to.value < frames);
    graph.nodes.push_back(transition.from);
    graph.nodes.push_back(transition.to);
  }
  std::sort(graph.nodes.begin(), graph.nodes.end());
  graph.nodes.erase(std::unique(graph.nodes.begin(), graph.nodes.end()), graph.nodes.end());
  for (std::size_t n = 0; n + 1 < graph.nodes.size(); ++n) {
    // The next node begins a clip of its own, or goes on with this one.
    if (!std::binary_search(clipStarts.begin(), clipStarts.end(), graph.nodes[n + 1].value))
      graph.edges.push_back(clipPiece(graph.nodes, NodeIndex(n), NodeIndex(n + 1)));
  }
  for (const FrameTransition& transition : transitions) {
    graph.edges.push_back({nodeAt(graph.nodes, transition.from), nodeAt(graph.nodes, transition.to),
                           EdgeKind::kTransition, transition.frames, transition.sourceSpan,
                           transition.targetSpan, transition.distanceMetres});
  }
  indexEdges(graph);
  return graph;
}

MotionGraph partOf(const MotionGraph& graph, const std::vector<bool>& keep) {
  MotionGraph part;
  std::vector<NodeIndex> newIndex(graph.nodes.size());
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    if (!keep[n]) continue;
    newIndex[n] = NodeIndex(part.nodes.size());
    part.nodes.push_back(graph.nodes[n]);
  }
  for (MotionEdge edge : graph.edges) {
    if (!keep[edge.from.value] || !keep[edge.to.value]) continue;
    edge.from = newIndex[edge.from.value];
    edge.to = newIndex[edge.to.value];
    part.edges.push_back(edge);
  }
  indexEdges(part);
  return part;
}

MotionGraph largestStronglyConnectedPart(const MotionGraph& graph) {
  const std::vector<std::uint32_t> component = ComponentFinder(graph).run();
  std::vector<std::size_t> sizes(graph.nodes.size(), 0);
  std::vector<bool> hasEdge(graph.nodes.size(), false);
  for (const std::uint32_t c : component) ++sizes[c];
  for (const MotionEdge& edge : graph.edges) {
    if (component[edge.from.value] == component[edge.to.value]) hasEdge[component[edge.from.value]] = true;
  }
  std::optional<std::uint32_t> best;
  for (const std::uint32_t c : component) {
    if (hasEdge[c] && (!best || sizes[c] > sizes[*best])) best = c;
  }
  std::vector<bool> keep(graph.nodes.size(), false);
  for (std::size_t n = 0; n < keep.size(); ++n) keep[n] = best && component[n] == *best;
  return partOf(graph, keep);
}

MotionGraph withoutPassThroughNodes(const MotionGraph& graph) {
  const std::size_t count = graph.nodes.size();
  std::vector<std::uint32_t> in(count, 0);
  std::vector<bool> touchesTransition(count, false);
  for (const MotionEdge& edge : graph.edges) {
    ++in[edge.to.value];
    if (edge.kind != EdgeKind::kTransition) continue;
    touchesTransition[edge.from.value] = touchesTransition[edge.to.value] = true;
  }
  std::vector<bool> keep(count, true);
  for (std::size_t n = 0; n < count; ++n) {
    const std::uint32_t out = graph.firstEdge[n + 1] - graph.firstEdge[n];
    keep[n] = touchesTransition[n] || in[n] != 1 || out != 1;
  }
  MotionGraph result = partOf(graph, keep);
  for (const MotionEdge& edge : graph.edges) {
    if (edge.kind != EdgeKind::kClipPiece || !keep[edge.from.value] || keep[edge.to.value]) continue;
    // Follow the run of dissolved nodes to the next that stays. Time only goes on in clip pieces, so it ends.
    NodeIndex end = edge.to;
    while (!keep[end.value]) end = graph.edges[graph.firstEdge[end.value]].to;
    result.edges.push_back(clipPiece(result.nodes, nodeAt(result.nodes, graph.nodes[edge.from.value]),
                                     nodeAt(result.nodes, graph.nodes[end.value])));
  }
  indexEdges(result);
  return result;
}

}  // namespace stridegraph
