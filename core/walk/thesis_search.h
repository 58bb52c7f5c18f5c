#pragma once

#include "walk/motion_search.h"

namespace stridegraph {

/// Settings of the thesis's search.
struct ThesisSearchParams {
  /// d of algorithm 5.5.2 for the subgoals on the way, metres; the goal itself is reached within the goal
  /// radius.
  double reachMetres = 0.5;
  std::uint64_t maxExpansions =
      300'000;                   ///< For the whole walk; without a memory of states it may circle for ever.
  bool checkCollisions = false;  ///< Leave out edges along which any frame touches something.
};

/// Algorithms 5.5.1 and 5.5.2 as printed: from subgoal to subgoal, best first by fit = (2 - cos alpha) d
/// (eq. 5.11), beginning at a seeded random node. It keeps no memory of states, never returns to an
/// earlier subgoal and, unless told to, does not look at obstacles: the baseline that the guided search is
/// measured against.
MotionResult thesisSearch(const MotionQuery& query, const ThesisSearchParams& params = {});

}  // namespace stridegraph
