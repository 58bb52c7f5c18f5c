#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "walk/search_graph.h"
#include "walk/walk_cost.h"

namespace stridegraph {

/// A way of some metres from a decision node to a stand, over open floor.
struct Arrival {
  static constexpr std::uint32_t kNone = SearchEdge::kNone;

  FloorTransform end;  ///< Where the body stands, relative to its placement at the node.
  double costMetres = 0.0;
  std::uint32_t edge = 0;      ///< First way to go: of SearchGraph::edges().
  std::uint32_t next = kNone;  ///< The arrival to go on with; kNone where `edge` itself comes to the stand.
};

/// One of the ways that an arrival goes.
struct ArrivalWay {
  const SearchEdge& edge;
  bool stops = false;  ///< The last one: it is over where the body has come to a stand.

  std::uint32_t samples() const { return stops ? edge.settledSample + 1 : edge.sampleCount; }
  double share() const { return stops ? edge.settledShare() : 1.0; }
  const FloorTransform& end() const { return stops ? edge.settledEnd : edge.end; }
};

/// Ways to come to a stand, for every decision node of a library, so that a search need not hit upon the goal
/// by going on blindly: seen from a node near the goal, it looks up which way ends there (the analytic
/// expansion of hybrid-state A*, Dolgov et al. 2008, with a table in place of a formula). Found backwards
/// from all stands by Dijkstra's algorithm, one for each node, place and heading in cells. Every node has its
/// share, lest nodes within stands, from which next to nothing leads to hundreds of others, leave none for
/// those that are still walking. Borrows the graph.
class ArrivalTable {
 public:
  struct Params {
    double reachMetres = 4.0;         ///< Longest way, by its cost.
    double cellMetres = 0.1;          ///< Ends in the same cell ...
    std::uint32_t headingCells = 36;  ///< ... facing the same of so many sectors count as one.
    std::uint32_t mostOfNode = 40;    ///< Kept for each node, cheapest first; more save no work.
  };

  ArrivalTable(const SearchGraph& graph, const WalkCost& cost, double framesPerSecond, const Params& params);

  const Arrival& operator[](std::uint32_t arrival) const { return arrivals_[arrival]; }
  std::size_t size() const { return arrivals_.size(); }
  /// Arrivals of a node whose stand lies within `radiusMetres` of a point, seen from the node; cheapest
  /// first.
  std::vector<std::uint32_t> near(std::uint32_t node, const Vec2& point, double radiusMetres) const;
  /// Calls visit(way) for the ways of an arrival, in turn, as long as it returns true; whether it always did.
  template <typename Visit>
  bool visitWays(const SearchGraph& graph, std::uint32_t arrival, const Visit& visit) const {
    for (; arrival != Arrival::kNone; arrival = arrivals_[arrival].next) {
      const Arrival& at = arrivals_[arrival];
      if (!visit(ArrivalWay{graph.edges()[at.edge], at.next == Arrival::kNone})) return false;
    }
    return true;
  }
  /// What coming to a stand takes at least from a node; the table's reach where it knows no way.
  double leastMetres(std::uint32_t node) const { return least_[node]; }
  double reachMetres() const { return reachMetres_; }

 private:
  struct Building;
  void indexByNode(const std::vector<std::uint32_t>& nodeOf, std::size_t nodeCount);

  double reachMetres_;
  std::vector<Arrival> arrivals_;
  std::vector<std::uint32_t> firstOfNode_;  ///< Into byNode_; one entry more than nodes.
  std::vector<std::uint32_t> byNode_;       ///< Arrivals node by node, each by the x of its end.
  std::vector<double> least_;
};

}  // namespace stridegraph
