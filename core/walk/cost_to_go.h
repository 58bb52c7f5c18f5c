#pragma once

#include <cstdint>
#include <vector>

#include "path/distance_field.h"
#include "walk/search_tables.h"

namespace stridegraph {

/// What a walk still costs from a state to the goal, as well as it can be told without searching: the disc's
/// way around the obstacles (DistanceField) at the cost per metre of the library's cheapest straight walk,
/// what it takes this node to get going along that way, and what the turns of the way ahead take. An
/// estimate, not a lower bound. What is known of a place is worked out when it is first asked for; answers do
/// not depend on the order of the questions.
class CostToGo {
 public:
  CostToGo(const SearchTables& tables, const DistanceField& field, const Vec2& roomSize);

  /// Metres; infinite where the goal cannot be reached.
  double metres(std::uint32_t node, const FloorTransform& placement);

 private:
  /// A place of a grid over the floor: which way leads on, and how far that way turns until the goal.
  struct Post {
    float sin = 0.0F, cos = 0.0F;
    float turnedRadians = 0.0F;
    enum : std::uint8_t { kUnknown, kOpen, kKnown, kClosed } state = kUnknown;
  };

  std::size_t nearestPost(const Vec2& point) const;
  Vec2 placeOf(std::size_t post) const;
  const Post& known(std::size_t post);
  void look(std::size_t post);
  std::size_t onwardFrom(std::size_t post) const;
  double turnedAhead(const Vec2& point);

  const SearchTables& tables_;
  const DistanceField& field_;
  double pitchMetres_;
  std::size_t columns_, rows_;
  std::vector<Post> posts_;
  std::vector<std::size_t> trail_;
};

}  // namespace stridegraph
