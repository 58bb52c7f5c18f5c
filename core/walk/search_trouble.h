#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "path/floor_plan.h"

namespace stridegraph {

/// What stood in the way of a search that found nothing.
struct SearchTrouble {
  bool begun = false;           ///< Some way to begin could be walked to its end.
  Vec2 blocked = Vec2::Zero();  ///< Where the first ways to begin touch something.
  Vec2 nearest = Vec2::Zero();  ///< Of the places reached the one from which the least way was left,
  double metresLeft = std::numeric_limits<double>::infinity();  ///< and how much.
  std::uint64_t atTraffic = 0;  ///< Ways not gone since something that moves was there,
  std::uint64_t tooLate = 0;    ///< or since the goal could not have been reached in time,
  double soonestSeconds = std::numeric_limits<double>::infinity();  ///< but after about so long at best.

  /// Takes in what another run of the same search saw.
  void add(const SearchTrouble& other);
};

/// What is nearest to a place: "obstacle 3 at (4.0, 5.5)", counted from 1, or "the room's wall".
std::string nearestThing(const FloorPlan& plan, const Vec2& point);

/// Where a search came nearest to the goal: "the nearest to the goal came to (3.0, 4.5), 2.1 m before it,
/// beside the room's wall".
std::string nearestReached(const SearchTrouble& trouble, const FloorPlan& plan);

/// A sentence for people: where the search got stuck, and at what.
std::string explainNoMotion(const SearchTrouble& trouble, const FloorPlan& plan, const Vec2& start);

}  // namespace stridegraph
