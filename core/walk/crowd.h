#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "walk/overlaps.h"
#include "walk/planning.h"

namespace stridegraph {

/// All walkers of a scene: planned one after the other, each around those before it; then each looks for a
/// better walk among the walks of all others. Does not move, since its parts refer to one another.
class Crowd {
 public:
  /// Scene and options are in range. Walks begin anew, or go on from a frame of `current`, which has as many
  /// walkers. What `prepared` refers to has to outlive the crowd. Finds the first walks.
  Crowd(const Prepared& prepared, const Scene& scene, const PlanOptions& options,
        std::optional<Plan> current = {}, std::size_t frame = 0);
  Crowd(const Crowd&) = delete;
  Crowd& operator=(const Crowd&) = delete;

  /// The plan of the first walker with all others.
  Plan plan() const&;
  /// The same of a crowd that is not needed any more.
  Plan plan() &&;

  /// See MotionSearch. One walker after the other uses up the expansions that the options allow each.
  bool canImprove() const { return turn_ < turns_.size(); }
  bool improve(std::uint64_t expansions);
  double progress() const;

 private:
  /// One walker's planning, and what it plans around.
  struct Turn {
    Turn(const Crowd& crowd, std::size_t who, Traffic others);
    std::size_t walker;
    Traffic traffic;
    PlanTask task;
    Planning planning;
  };
  using Turns = std::vector<std::unique_ptr<Turn>>;

  const Plan* underWay(std::size_t walker) const;
  void findFirst();
  std::optional<std::size_t> planInTurn(const std::vector<std::size_t>& order, bool mayGoFirst);
  bool isInTheWay(std::size_t walker, Traffic& traffic) const;
  void meet(std::size_t other, bool planned, Traffic& traffic) const;
  void beginTurn();
  Plan joined(std::vector<Plan> plans) const;

  Prepared prepared_;
  Scene scene_;
  PlanOptions options_;
  FloorPlan floor_;
  std::optional<Plan> current_;
  std::size_t frame_;
  Traffic obstacles_;
  std::vector<Walker> walkers_;
  std::vector<std::optional<Refusal>> refusals_;  ///< For each walker why it is not planned, if so.
  std::vector<bool> wentFirst_;                   ///< Who has gone before all others once.
  std::vector<Plan> plans_;
  Turns turns_;           ///< In the order in which walkers were planned; empty when walks are not improved.
  std::size_t turn_ = 0;  ///< Who looks for a better walk.
};

}  // namespace stridegraph
