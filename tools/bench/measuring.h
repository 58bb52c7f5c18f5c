#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/clock.h"
#include "bench/bench_run.h"
#include "path/floor_plan.h"
#include "walk/walk_planner.h"

namespace stridegraph::bench {

/// How runs are measured.
struct MeasureParams {
  double goalRadiusMetres = 0.1;
  double thesisBudgetMilliseconds = 200.0;  ///< For each search of the thesis, which may circle for ever.
  double improveMilliseconds = 50.0;        ///< For which an improving search goes on after its first walk.
  int repeats = 1;  ///< The quickest of so many counts: what else runs on a machine only ever adds time.
  MillisecondClock clock;
};

/// A search of motions, as it is measured.
struct WalkMethod {
  std::string name;
  SearchKind search = SearchKind::kGuided;
  bool improves = false;  ///< Goes on for MeasureParams::improveMilliseconds after the first walk.
};

inline const WalkMethod kGuidedMethod{"guided", SearchKind::kGuided, false};

/// "guided", "guided-improved", "thesis" and "thesis-checked".
std::vector<WalkMethod> walkMethods();

/// What a path planner says.
struct PathAnswer {
  std::string status;  ///< pathStatusName()
  double lengthMetres = 0.0;
  std::vector<Vec2> path;
};

/// A planner of paths, ours or another's.
struct PathMethod {
  std::string name;
  bool seeded = true;  ///< Whether the seed makes a difference.
  std::function<PathAnswer(const FloorPlan&, const Placement& start, const Placement& goal, std::uint64_t)>
      plan;
};

/// "exact", "prm" and "rrt-connect".
std::vector<PathMethod> pathMethods();

/// A walk through a room, for the bench's disc and goal radius.
BenchRun measureWalk(const WalkPlanner& planner, const BenchRoom& room, const WalkMethod& method,
                     std::uint64_t seed, const MeasureParams& params);

/// A path alone. Its clearance is that of all its points, or negative where a segment is not free.
BenchRun measurePath(const PathMethod& method, const BenchRoom& room, std::uint64_t seed,
                     const MeasureParams& params);

}  // namespace stridegraph::bench
