#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "walk/search_graph.h"
#include "walk/walk_cost.h"

namespace stridegraph {

/// What it takes, beside the bare way, to get a body going: for every decision node and every direction the
/// cost by which the cheapest walk that goes on in that direction exceeds the cheapest endless straight walk
/// of the library. It knows how dear a turn is for this node, and that transitions and time cost something on
/// every metre, so that a search does not have to find this out anew in every room.
///
/// The relative value function of an average-cost decision process (Puterman 1994, section 8.2; semi-Markov,
/// since ways differ in length), by value iteration, Gauss-Seidel: first the cost per metre, then values that
/// look some ways ahead. Immutable; the same on every machine.
class SteeringTable {
 public:
  static constexpr std::uint32_t kSectors = 32;

  /// What a way costs beyond what WalkCost says, metres, 0 or more.
  using MoreCost = std::function<double(const SearchEdge&)>;

  SteeringTable(const SearchGraph& graph, const WalkCost& cost, double framesPerSecond,
                const MoreCost& more = {});

  /// Cost of the cheapest endless straight walk for each metre of progress, > 0: metres per metre.
  double costPerMetre() const { return costPerMetre_; }
  /// Metres of cost that going from the node in a direction takes more than that; 0 for the best of all nodes
  /// and directions. The direction is relative to the heading of the placement at the node; only the ratio of
  /// its (sin, cos) counts. Linear between kSectors directions.
  double extraMetres(std::uint32_t node, const Heading& direction) const;

 private:
  static constexpr std::uint32_t kRow =
      2 * kSectors + 1;  ///< Every row once more, to be read across its end.

  friend class SteeringIteration;
  static constexpr double kQuarterTurnsPerSector = 4.0 / kSectors;

  /// nodes x kRow; once found, by quarterTurns().
  std::vector<float> values_;
  double costPerMetre_ = 1.0;
};

}  // namespace stridegraph
