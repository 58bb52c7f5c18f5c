#pragma once

#include "walk/motion_search.h"

namespace stridegraph {

/// What a walk costs, in metres: its length, and what else we would walk further to avoid.
struct WalkCost {
  double perSecond = 0.05;          ///< Standing about is not free.
  double perTransition = 0.1;       ///< Else three quarters of all frames would be blends.
  double perTransitionMetre = 2.5;  ///< Times the transition's distance: good blends are preferred.
  double seedVariation = 0.05;      ///< A way costs up to this share more, by seed: other seeds, other walks.
};

/// The strategy of one stage; the defaults are those of the first.
struct GuidedStage {
  double heuristicWeight = 1.3;     ///< w of weighted A* (Pohl 1970).
  double transitionFactor = 1.0;    ///< On the costs of transitions.
  double cellMetres = 0.2;          ///< States in the same cell, at the same node, count as one ...
  std::uint32_t headingCells = 24;  ///< ... when they also face the same of so many sectors.
  bool turnStart = false;           ///< Also try the start turned by startSlack to either side.
  std::uint64_t maxExpansions = 40'000;
  double expansionsPerMetre = 250.0;  ///< Added to maxExpansions for each metre from start to goal.
};

struct GuidedSearchParams {
  WalkCost cost;
  Angle startSlack = Angle::degrees(12.0);  ///< How far the first heading may be off when nothing else helps.
};

/// Weighted A* over (node, place, heading) with every frame checked against the room, a cost-to-go that knows
/// the room's geometry, and a memory of states reached before. Where the first stage finds nothing, others
/// follow: with a turned start and finer cells when the open list ran empty, with a greedier search when its
/// budget ran out. Says no motion only when a stage with fine cells has run through every state it can reach.
MotionResult guidedSearch(const MotionQuery& query, const GuidedSearchParams& params = {});

}  // namespace stridegraph
