#include "bench/measuring.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/hash.h"
#include "path/path_planner.h"
#include "path/shortest_path.h"

namespace stridegraph::bench {
namespace {

/// "from-to," for each edge: what Node.js hashes, too.
std::string edgesHash(const PlanReport& report) {
  if (report.edges.empty()) return {};
  std::string text;
  for (const auto& [from, to] : report.edges) text += fmt::format("{}-{},", from.value, to.value);
  return hexDigits(stableHash(text));
}

double blendedShare(const Plan& plan) {
  if (plan.frameKinds.empty()) return 0.0;
  const auto blended = std::count(plan.frameKinds.begin(), plan.frameKinds.end(), EdgeKind::kTransition);
  return static_cast<double>(blended) / static_cast<double>(plan.frameKinds.size());
}

BenchRun runIn(const BenchRoom& room, std::uint64_t seed, const MeasureParams& params) {
  BenchRun run;
  run.place = "native";
  run.set = room.set;
  run.room = room.name;
  run.seed = seed;
  run.shortestMetres = room.shortestMetres;
  run.goalRadiusMetres = params.goalRadiusMetres;
  return run;
}

void takeFigures(const Plan& plan, BenchRun& run) {
  const PlanReport& report = plan.report;
  run.status = planStatusName(report.status);
  run.explanation = report.explanation;
  run.pathMilliseconds = report.pathMilliseconds;
  run.motionMilliseconds = report.motionMilliseconds;
  run.synthesisMilliseconds = report.synthesisMilliseconds;
  run.totalMilliseconds = report.totalMilliseconds;
  run.expansions = static_cast<double>(report.expansions);
  run.lengthMetres = report.motionLengthMetres;
  run.durationSeconds = report.durationSeconds;
  run.transitions = static_cast<double>(report.transitions);
  run.blendedShare = blendedShare(plan);
  run.clearanceMetres = report.clearanceMetres;
  run.arrivalErrorMetres = report.arrivalErrorMetres;
  run.edges = edgesHash(report);
}

/// The quickest of some runs that are alike but for their times.
template <typename Measure>
BenchRun quickestOf(int repeats, const Measure& measure) {
  BenchRun quickest = measure();
  for (int i = 1; i < repeats; ++i) {
    BenchRun again = measure();
    if (again.totalMilliseconds < quickest.totalMilliseconds) quickest = std::move(again);
  }
  return quickest;
}

PathAnswer answerOf(const PathResult& result) {
  return {std::string(pathStatusName(result.status)), result.lengthMetres, result.path};
}

PathAnswer exactPath(const FloorPlan& plan, const Placement& start, const Placement& goal, std::uint64_t) {
  const std::optional<ShortestPath> path = shortestPath(plan, start.position, goal.position);
  if (!path) return {std::string(pathStatusName(PathStatus::kNoPath)), 0.0, {}};
  return {std::string(pathStatusName(PathStatus::kFound)), path->lengthMetres, path->points};
}

double clearanceAlong(const FloorPlan& plan, const std::vector<Vec2>& path) {
  double smallest = plan.clearance(path.front());
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (!plan.isFree(path[i - 1], path[i])) return -plan.radiusMetres();
    smallest = std::min(smallest, plan.clearance(path[i]));
  }
  return smallest;
}

}  // namespace

std::vector<PathMethod> pathMethods() {
  std::vector<PathMethod> methods = {{"exact", false, exactPath}};
  for (const PlannerKind kind : {PlannerKind::kPrm, PlannerKind::kRrtConnect}) {
    methods.push_back(
        {std::string(plannerName(kind)), true,
         [kind](const FloorPlan& plan, const Placement& start, const Placement& goal, std::uint64_t seed) {
           return answerOf(planPath(plan, start.position, goal.position, kind, seed));
         }});
  }
  return methods;
}

std::vector<WalkMethod> walkMethods() {
  std::vector<WalkMethod> methods = {kGuidedMethod, {"guided-improved", SearchKind::kGuided, true}};
  for (const SearchKind search : {SearchKind::kThesis, SearchKind::kThesisChecked})
    methods.push_back({std::string(searchName(search)), search, false});
  return methods;
}

BenchRun measureWalk(const WalkPlanner& planner, const BenchRoom& room, const WalkMethod& method,
                     std::uint64_t seed, const MeasureParams& params) {
  PlanOptions options;
  options.seed = seed;
  options.search = method.search;
  options.goalRadiusMetres = params.goalRadiusMetres;
  options.clock = params.clock;
  if (method.search != SearchKind::kGuided) options.budgetMilliseconds = params.thesisBudgetMilliseconds;
  if (method.improves) {
    // The budget counts from the search's beginning, so the time of the first walk comes on top.
    const Result<Plan> first = planner.plan(room.scene, options);
    if (first) options.budgetMilliseconds = first->report.motionMilliseconds + params.improveMilliseconds;
    options.improvementExpansions = std::numeric_limits<std::uint64_t>::max();
  }
  return quickestOf(params.repeats, [&] {
    BenchRun run = runIn(room, seed, params);
    run.method = method.name;
    if (const Result<Plan> plan = planner.plan(room.scene, options)) {
      takeFigures(*plan, run);
    } else {
      run.status = errorCodeName(plan.error().code);
      run.explanation = describe(plan.error());
    }
    return run;
  });
}

BenchRun measurePath(const PathMethod& method, const BenchRoom& room, std::uint64_t seed,
                     const MeasureParams& params) {
  return quickestOf(params.repeats, [&] {
    BenchRun run = runIn(room, seed, params);
    run.method = method.name;
    const double begin = params.clock();
    const FloorPlan plan(room.scene, room.scene.radiusMetres);
    const double ready = params.clock();
    const PathAnswer answer = method.plan(plan, room.scene.start, room.scene.goal, seed);
    const double end = params.clock();
    run.status = answer.status;
    run.pathMilliseconds = end - ready;
    run.totalMilliseconds = end - begin;
    run.lengthMetres = answer.lengthMetres;
    if (answer.path.empty()) return run;
    run.clearanceMetres = clearanceAlong(plan, answer.path);
    run.arrivalErrorMetres = (answer.path.back() - room.scene.goal.position).norm();
    return run;
  });
}

}  // namespace stridegraph::bench
