#pragma once

#include <limits>
#include <memory>

#include "walk/motion_search.h"
#include "walk/walk_cost.h"

namespace stridegraph {

/// The strategy of one stage.
struct GuidedStage {
  double heuristicWeight = 1.2;     ///< w of weighted A* (Pohl 1970) at first;
  double weightGrowth = 1.04;       ///< grows by this factor as more and more states are looked at.
  double transitionFactor = 1.0;    ///< On the costs of transitions.
  bool everyWay = true;             ///< Else it begins and goes on in usual ways only (SearchGraph).
  double cellMetres = 0.2;          ///< States in the same cell, at the same node, count as one ...
  std::uint32_t headingCells = 24;  ///< ... when they also face the same of so many sectors.
  std::uint64_t maxExpansions = 40'000;
  double expansionsPerMetre = 250.0;  ///< Added to maxExpansions for each metre from start to goal.
  double expansionsPerMover = 0.0;    ///< And for each of the others who move.
  /// States this much further from the goal than the nearest one looked at are passed over, metres of way.
  double windowMetres = std::numeric_limits<double>::infinity();
};

struct GuidedSearchParams {
  WalkCost cost;
  Angle startSlack = Angle::degrees(12.0);  ///< How far the first heading may be off, at a price.
};

/// Weighted A* over (node, place, heading) with every frame checked against the room, a cost-to-go that knows
/// the room's geometry and the library's turns (CostToGo), and a memory of states reached before. It begins
/// with little greed, which grows with the number of states looked at; finer cells follow when the open list
/// ran empty, and one greedy attempt when the budget ran out. A walk that comes to a stand, and faces as the
/// goal asks, is sought first; where there is none, the standing and then the heading are given up. Says no
/// motion only when a stage with fine cells has run through every state it can reach.
///
/// Then it can be carried on for better walks, slice by slice: it searches again, each time for a walk that
/// costs less than the best so far, with blends at half their price: without greed, but only so far behind
/// the front, and further behind it each time (Anytime Window A*, Aine, Chakrabarti and Kumar 2007; here the
/// front is the state nearest to the goal instead of the deepest). Estimates have learned from the best walk
/// what the room costs (Adaptive A*, Koenig and Likhachev 2005; here by distance from the goal and to a
/// share, since neither estimate is a bound).
class GuidedSearch : public MotionSearch {
 public:
  explicit GuidedSearch(const MotionQuery& query, const GuidedSearchParams& params = {});
  ~GuidedSearch() override;
  GuidedSearch(const GuidedSearch&) = delete;
  GuidedSearch& operator=(const GuidedSearch&) = delete;

  const MotionResult& best() const override;
  bool canImprove() const override;
  bool improve(std::uint64_t expansions) override;
  double progress() const override;

 private:
  class Stages;
  std::unique_ptr<Stages> stages_;
};

/// The best walk within the query's improvement expansions.
MotionResult guidedSearch(const MotionQuery& query, const GuidedSearchParams& params = {});

}  // namespace stridegraph
