#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "path/distance_field.h"
#include "walk/pace_tables.h"
#include "walk/steering.h"

namespace stridegraph {

/// What a walk still costs from a state to the goal, as well as it can be told without searching: the disc's
/// way around the obstacles (DistanceField) at the cost per metre of the library's cheapest straight walk,
/// what it takes this node to get going along that way, and what the turns of the way ahead take. An
/// estimate, not a lower bound. What is known of a place is worked out when it is first asked for, at posts
/// of a grid over the floor, and read between them; answers do not depend on the order of the questions.
class CostToGo {
 public:
  /// `pace`: of who is asked for one; null for all others.
  CostToGo(const SteeringTable& steering, const DistanceField& field, const Vec2& roomSize,
           const PaceTable* pace = nullptr);

  /// Metres; infinite where the goal cannot be reached. With what was learned.
  double metres(std::uint32_t node, const FloorTransform& placement);
  /// The same without what was learned.
  double estimate(std::uint32_t node, const FloorTransform& placement);

  /// Whether the walk is to end with a stand, which matters to who has to give up a pace for it; not at
  /// first.
  void comeToStand(bool stand) { comesToStand_ = stand; }

  /// By how much the estimate was wrong for a walk that was found, at a distance from the goal.
  struct Mark {
    double metresToGoal = 0.0;  ///< Of the field.
    double extraMetres = 0.0;   ///< What was left to pay there, less the estimate.
  };
  /// Remembers a walk that was found, by rising distance from the goal.
  void learn(std::vector<Mark> marks) { marks_ = std::move(marks); }
  /// Believes that walk to a share of 0..1, wherever the goal is as far as there; 0 at first. With 1
  /// estimates are as good as the walk on its own way.
  void trust(double share) { trust_ = share; }

 private:
  /// What is known of a place: how far the goal is, which way leads there, and how far that way turns.
  struct Prospect {
    float metres = 0.0F;
    float sin = 0.0F, cos = 0.0F;
    float turnedRadians = 0.0F;
  };
  /// A place of the grid.
  struct Post {
    Prospect prospect;
    enum : std::uint8_t { kUnknown, kOpen, kKnown, kClosed } state = kUnknown;
  };

  static double along(const SteeringTable& steering, std::uint32_t node, const Heading& facing,
                      const Prospect& at);
  double learnedMetres(double metresToGoal) const;
  std::size_t nearestPost(const Vec2& point) const;
  Vec2 placeOf(std::size_t post) const;
  const Post& known(std::size_t post);
  void look(std::size_t post);
  std::size_t onwardFrom(std::size_t post) const;
  std::optional<Prospect> prospectAt(const Vec2& point);

  const SteeringTable& steering_;
  const PaceTable* pace_;
  const DistanceField& field_;
  double pitchMetres_;
  std::size_t columns_, rows_;
  std::vector<Post> posts_;
  std::vector<std::size_t> trail_;
  std::vector<Mark> marks_;
  double trust_ = 0.0;
  bool comesToStand_ = false;
};

}  // namespace stridegraph
