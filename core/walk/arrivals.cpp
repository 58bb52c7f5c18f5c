#include "walk/arrivals.h"

#include <algorithm>
#include <utility>

#include "walk/search_heap.h"
#include "walk/state_set.h"

namespace stridegraph {

/// Dijkstra's algorithm backwards from all stands.
struct ArrivalTable::Building {
  /// An arrival before its turn has come: where it ends is worked out then, for most never.
  struct Open {
    std::uint32_t edge = 0;
    std::uint32_t next = Arrival::kNone;
    double costMetres = 0.0;
  };

  const SearchGraph& graph;
  const WalkCost& cost;
  double framesPerSecond;
  const Params& params;
  std::vector<Open> open;
  SearchHeap heap;
  StateSet closed;
  std::vector<std::uint32_t> ofNode;  ///< How many arrivals a node has.

  /// Opens the arrival that goes this way, some share of it, and then on with one that is known.
  void push(const SearchEdge& edge, double share, std::uint32_t next, double costMetres) {
    // Ways as captured will do: a walk's end is bent to the goal anyway.
    if (edge.bendRadians > 0.0 || ofNode[edge.from] == params.mostOfNode) return;
    const double whole = share * cost.ofWay(edge, framesPerSecond) + costMetres;
    if (whole > params.reachMetres) return;
    heap.push(whole, static_cast<std::uint32_t>(open.size()));
    open.push_back({graph.indexOf(edge), next, whole});
  }

  std::uint64_t key(std::uint32_t node, const FloorTransform& end) const {
    // Ends lie within the reach of the node on all sides.
    const Vec2 cell = (end.translation + Vec2::Constant(2.0 * params.reachMetres)) / params.cellMetres;
    const std::uint64_t turn = keyPart(quarterTurns(end.heading) * 0.25 * params.headingCells);
    const std::uint64_t x = keyPart(cell.x());
    const std::uint64_t z = keyPart(cell.y());
    return ((node * 0x4000ULL + x) * 0x4000ULL + z) * 0x100ULL + turn;
  }

  /// Fills the table; returns the node of each arrival.
  std::vector<std::uint32_t> run(std::vector<Arrival>& arrivals) {
    std::vector<std::uint32_t> nodeOf;
    ofNode.assign(graph.nodeCount(), 0);
    for (const SearchEdge& edge : graph.edges())
      if (edge.settledSample != SearchEdge::kNone) push(edge, edge.settledShare(), Arrival::kNone, 0.0);
    while (!heap.empty()) {
      const Open at = open[heap.pop()];
      const SearchEdge& edge = graph.edges()[at.edge];
      if (ofNode[edge.from] == params.mostOfNode) continue;
      const FloorTransform end =
          at.next == Arrival::kNone ? edge.settledEnd : edge.end * arrivals[at.next].end;
      if (!closed.insert(key(edge.from, end))) continue;
      ++ofNode[edge.from];
      const auto next = static_cast<std::uint32_t>(arrivals.size());
      arrivals.push_back({end, at.costMetres, at.edge, at.next});
      nodeOf.push_back(edge.from);
      for (const std::uint32_t way : graph.edgesInto(edge.from))
        push(graph.edges()[way], 1.0, next, at.costMetres);
    }
    return nodeOf;
  }
};

ArrivalTable::ArrivalTable(const SearchGraph& graph, const WalkCost& cost, double framesPerSecond,
                           const Params& params)
    : reachMetres_(params.reachMetres), least_(graph.nodeCount(), params.reachMetres) {
  Building building{graph, cost, framesPerSecond, params, {}, {}, {}, {}};
  const std::vector<std::uint32_t> nodeOf = building.run(arrivals_);
  for (std::size_t a = 0; a < arrivals_.size(); ++a) {
    double& least = least_[nodeOf[a]];
    least = std::min(least, arrivals_[a].costMetres);
  }
  indexByNode(nodeOf, graph.nodeCount());
}

void ArrivalTable::indexByNode(const std::vector<std::uint32_t>& nodeOf, std::size_t nodeCount) {
  firstOfNode_.assign(nodeCount + 1, 0);
  for (const std::uint32_t node : nodeOf) ++firstOfNode_[node + 1];
  for (std::size_t n = 0; n < nodeCount; ++n) firstOfNode_[n + 1] += firstOfNode_[n];
  byNode_.resize(arrivals_.size());
  std::vector<std::uint32_t> free(firstOfNode_.begin(), firstOfNode_.end() - 1);
  for (std::uint32_t a = 0; a < arrivals_.size(); ++a) byNode_[free[nodeOf[a]]++] = a;
  const auto key = [&](std::uint32_t a) { return std::pair(arrivals_[a].end.translation.x(), a); };
  for (std::size_t n = 0; n < nodeCount; ++n) {
    std::sort(byNode_.begin() + static_cast<std::ptrdiff_t>(firstOfNode_[n]),
              byNode_.begin() + static_cast<std::ptrdiff_t>(firstOfNode_[n + 1]),
              [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  }
}

std::vector<std::uint32_t> ArrivalTable::near(std::uint32_t node, const Vec2& point,
                                              double radiusMetres) const {
  const auto first = byNode_.begin() + static_cast<std::ptrdiff_t>(firstOfNode_[node]);
  const auto last = byNode_.begin() + static_cast<std::ptrdiff_t>(firstOfNode_[node + 1]);
  auto at = std::lower_bound(first, last, point.x() - radiusMetres,
                             [&](std::uint32_t a, double x) { return arrivals_[a].end.translation.x() < x; });
  std::vector<std::uint32_t> found;
  for (; at != last && arrivals_[*at].end.translation.x() <= point.x() + radiusMetres; ++at) {
    if ((arrivals_[*at].end.translation - point).norm() <= radiusMetres) found.push_back(*at);
  }
  // Arrivals are numbered in the order in which they were closed, cheapest first.
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace stridegraph
