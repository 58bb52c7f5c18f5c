#include "path/path_planner.h"

#include <algorithm>
#include <cmath>

#include "path/connectivity.h"
#include "path/polyline.h"
#include "path/roadmap.h"
#include "path/rrt_connect.h"
#include "path/shortcut.h"
#include "path/shortest_path.h"

namespace stridegraph {

namespace {

/// How often a roadmap of the whole room grows after one along the distance field has missed the way.
constexpr int kGrowthsBesideField = 2;

std::vector<Vec2> refined(const FloorPlan& plan, const std::vector<Vec2>& path, std::size_t rounds,
                          Random& random) {
  if (rounds == 0) return path;
  const double pieces = std::ceil(polylineLength(path) / 50.0);
  return shortcut(plan, path, static_cast<std::size_t>(pieces) * std::min<std::size_t>(rounds, 10'000),
                  random);
}

}  // namespace

std::string_view plannerName(PlannerKind planner) {
  return planner == PlannerKind::kPrm ? "prm" : "rrt-connect";
}

std::optional<PlannerKind> plannerFromName(std::string_view name) {
  for (const PlannerKind kind : {PlannerKind::kPrm, PlannerKind::kRrtConnect}) {
    if (plannerName(kind) == name) return kind;
  }
  return std::nullopt;
}

std::string_view pathStatusName(PathStatus status) {
  switch (status) {
    case PathStatus::kFound:
      return "found";
    case PathStatus::kStartBlocked:
      return "start_blocked";
    case PathStatus::kGoalBlocked:
      return "goal_blocked";
    case PathStatus::kNoPath:
      return "no_path";
  }
  return "unknown";
}

PathResult planPath(const FloorPlan& plan, const Vec2& start, const Vec2& goal, PlannerKind planner,
                    std::uint64_t seed) {
  return planPath(plan, start, goal, planner, seed, PathParams{});
}

PathResult planPath(const FloorPlan& plan, const Vec2& start, const Vec2& goal, PlannerKind planner,
                    std::uint64_t seed, const PathParams& params) {
  PathResult result;
  if (!plan.isFree(start)) {
    result.status = PathStatus::kStartBlocked;
    return result;
  }
  if (!plan.isFree(goal)) {
    result.status = PathStatus::kGoalBlocked;
    return result;
  }
  if (!isConnected(plan, start, goal)) return result;
  Random random(seed);
  SampledPath sampled;
  if (planner == PlannerKind::kPrm && params.roadmapNodes == 0) {
    auto field = std::make_shared<const DistanceField>(plan, goal);
    if (std::isfinite(field->metresToGoal(start))) result.field = std::move(field);
    if (result.field) sampled = planAlongField(plan, start, *result.field, random);
  }
  if (planner == PlannerKind::kPrm && sampled.path.empty()) {
    // Where nodes along the field miss the way, it is so narrow that trees find it sooner than many nodes do.
    PathParams wholeRoom = params;
    if (params.roadmapNodes == 0) wholeRoom.growths = std::min(params.growths, kGrowthsBesideField);
    sampled = planByRoadmap(plan, start, goal, random, wholeRoom);
  }
  // A roadmap that misses a narrow way is rescued by trees, which grow into it; the exact path takes seconds
  // where there are thousands of rectangles.
  if (sampled.path.empty()) {
    SampledPath grown = planByTrees(plan, start, goal, random, params);
    if (planner == PlannerKind::kPrm) grown.edges = std::move(sampled.edges);
    sampled = std::move(grown);
  }
  result.roadmapEdges = std::move(sampled.edges);
  if (!sampled.path.empty()) {
    result.path = refined(plan, sampled.path, params.shortcutRounds, random);
  } else if (std::optional<ShortestPath> exact = shortestPath(plan, start, goal)) {
    result.path = std::move(exact->points);
    result.usedShortestPath = true;
  } else {
    return result;
  }
  result.path = withoutRepeats(result.path);
  if (result.path.size() == 1) result.path.push_back(goal);
  result.status = PathStatus::kFound;
  result.lengthMetres = polylineLength(result.path);
  return result;
}

}  // namespace stridegraph
