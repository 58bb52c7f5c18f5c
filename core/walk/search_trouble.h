#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "path/floor_plan.h"

namespace stridegraph {

/// What stood in the way of a search that found nothing.
struct SearchTrouble {
  bool begun = false;              ///< Some way to begin could be walked to its end.
  Vec2 blocked = Vec2::Zero();     ///< Where the first ways to begin touch something,
  std::uint32_t blockedFrame = 0;  ///< and at what frame of the walk.
  Vec2 nearest = Vec2::Zero();     ///< Of the places reached the one from which the least way was left,
  double metresLeft = std::numeric_limits<double>::infinity();  ///< and how much.
  std::uint64_t atTraffic = 0;  ///< Ways not gone since something that moves was there,
  std::uint64_t tooLate = 0;    ///< or since the goal could not have been reached in time,
  double soonestSeconds = std::numeric_limits<double>::infinity();  ///< but after about so long at best.

  /// Whether any place was reached at all.
  bool hasReached() const { return std::isfinite(metresLeft); }

  /// Takes in what another run of the same search saw.
  void add(const SearchTrouble& other);
};

/// What is nearest to a place: "obstacle 3 at (4.0, 5.5)", counted from 1, or "the room's wall".
std::string nearestThing(const FloorPlan& plan, const Vec2& point);

/// Where a search came nearest to the goal: "the nearest to the goal came to (3.0, 4.5), 2.1 m before it,
/// beside the room's wall", or that it came no farther than the start where it reached no place.
std::string nearestReached(const SearchTrouble& trouble, const FloorPlan& plan);

/// Where a search began, and what moved nearest to where its first steps were blocked: "walker 2".
struct SearchBeginning {
  Vec2 start = Vec2::Zero();
  std::string mover = "something that moves";
};

/// A sentence for people: where the search got stuck, and at what. All its figures are finite.
std::string explainNoMotion(const SearchTrouble& trouble, const FloorPlan& plan,
                            const SearchBeginning& beginning);

}  // namespace stridegraph
