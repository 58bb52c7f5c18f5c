#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "math/types.h"
#include "path/distance_field.h"
#include "path/floor_plan.h"

namespace stridegraph {

/// The planners of chapter 4.1 of the thesis.
enum class PlannerKind { kPrm, kRrtConnect };

std::string_view plannerName(PlannerKind planner);  ///< "prm", "rrt-connect"
std::optional<PlannerKind> plannerFromName(std::string_view name);

/// How the search for a path ended. kNoPath is proved (see isConnected), never guessed.
enum class PathStatus { kFound, kStartBlocked, kGoalBlocked, kNoPath };

std::string_view pathStatusName(PathStatus status);  ///< "found", "start_blocked", "goal_blocked", "no_path"

/// A path for the disc and what was looked at on the way to it.
struct PathResult {
  PathStatus status = PathStatus::kNoPath;
  std::vector<Vec2> path;     ///< From start to goal, every segment free; empty unless found.
  double lengthMetres = 0.0;  ///< Of the path.
  std::vector<std::pair<Vec2, Vec2>> roadmapEdges;  ///< Of the roadmap or of both trees, for showing.
  bool usedShortestPath = false;  ///< The sampling planner gave up, and the exact path stands in.
  /// How far it is to the goal from anywhere, where that was found out on the way; finite at the start.
  std::shared_ptr<const DistanceField> field;
};

/// What may be asked of the planners. Values out of range are clamped.
struct PathParams {
  /// Nodes of the first roadmap, anywhere in the room, 10..100,000 (the thesis draws 200 in rooms of some
  /// 30 m). 0 draws them where the distance field says that the way leads (see planAlongField); should they
  /// miss it, five for every 2 m2 of the room, 500 to 100,000.
  std::size_t roadmapNodes = 0;
  /// Neighbours that each node has on average, 1..100 (Kavraki et al. 1996 use 30 in many dimensions; on a
  /// floor 10 leave no gaps worth another node).
  std::size_t neighbours = 10;
  /// How often the roadmap grows when it misses a way that is known to exist, 0..20.
  int growths = 12;
  /// Longest step of the trees, metres, 0.05..100; 0 chooses 1 m, a thirtieth of the room where that is more
  /// (Kuffner and LaValle 2000 leave it to the problem).
  double stepMetres = 0.0;
  /// Samples before the trees give up, 1..1,000,000.
  std::size_t treeSamples = 20'000;
  /// Rounds of cutting corners off the path found for every 50 m of it, 0..10,000; 0 leaves it as the planner
  /// made it.
  std::size_t shortcutRounds = 200;
};

/// Plans a path for the disc. Blocked ends are said first, then whether there is a way at all is decided
/// exactly; only then the planner samples. Should a roadmap miss the way, trees are grown, and should they
/// miss it, the exact shortest path stands in. Same arguments, same answer.
PathResult planPath(const FloorPlan& plan, const Vec2& start, const Vec2& goal, PlannerKind planner,
                    std::uint64_t seed);
PathResult planPath(const FloorPlan& plan, const Vec2& start, const Vec2& goal, PlannerKind planner,
                    std::uint64_t seed, const PathParams& params);

}  // namespace stridegraph
