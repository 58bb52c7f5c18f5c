#include "walk/walk_planner.h"

#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <utility>

#include "scene/scene_json.h"
#include "walk/crowd.h"
#include "walk/keeping.h"

namespace stridegraph {
namespace {

Result<void> checkRange(std::string_view name, double value, double low, double high) {
  if (value >= low && value <= high) return {};
  return fail(ErrorCode::kInvalidArgument,
              fmt::format("{}: found {}, expected {} to {}", name, value, low, high));
}

Result<void> checkOptions(const PlanOptions& options) {
  if (options.radiusMetres) {
    if (auto checked = checkRange("radius", *options.radiusMetres, 0.05, 5.0); !checked) return checked;
  }
  if (options.enoughRatio) {
    if (auto checked = checkRange("until", *options.enoughRatio, 1.0, 10.0); !checked) return checked;
  }
  if (auto checked = checkRange("goal radius", options.goalRadiusMetres, 0.01, 5.0); !checked) return checked;
  if (auto checked = checkRange("subgoal spacing", options.subgoalSpacingMetres, 0.2, 20.0); !checked)
    return checked;
  return checkRange("budget in milliseconds", options.budgetMilliseconds, 0.0, 1e9);
}

/// The walk as it is, in another scene.
Plan keptIn(const Scene& scene, Plan walk) {
  walk.scene = scene;
  walk.kept = true;
  return walk;
}

FloorPlan floorOf(const Scene& scene, const PlanOptions& options) {
  return FloorPlan(scene, options.radiusMetres.value_or(scene.radiusMetres));
}

/// As good as it gets.
Result<Plan> finished(Result<AnytimePlan> plan) {
  if (!plan) return fail(std::move(plan));
  plan->step(std::numeric_limits<std::uint64_t>::max());
  return std::move(*plan).best();
}

}  // namespace

WalkPlanner::WalkPlanner(std::shared_ptr<const MotionLibrary> library)
    : library_(std::move(library)),
      sources_(sourceFigures(*library_)),
      tables_(*library_, sources_.limits),
      paces_(std::make_unique<PaceTables>(tables_.graph, tables_.steering, library_->frames.framesPerSecond)),
      feet_(*library_),
      standing_(standingBody(*library_, feet_.feet())) {}

Result<Plan> WalkPlanner::plan(const Scene& scene, const PlanOptions& options) const {
  return finished(begin(scene, options));
}

Result<AnytimePlan> WalkPlanner::begin(const Scene& scene, const PlanOptions& options) const {
  if (auto checked = checkScene(scene); !checked) return fail(std::move(checked));
  if (auto checked = checkOptions(options); !checked) return fail(std::move(checked));
  return AnytimePlan(std::make_unique<Crowd>(prepared(), scene, options), std::nullopt);
}

Result<Plan> WalkPlanner::replan(const Plan& current, std::size_t frame, const Scene& scene,
                                 const PlanOptions& options) const {
  return finished(beginOnward(current, frame, scene, options));
}

Result<AnytimePlan> WalkPlanner::beginOnward(const Plan& current, std::size_t frame, const Scene& scene,
                                             const PlanOptions& options) const {
  if (auto checked = checkScene(scene); !checked) return fail(std::move(checked));
  if (auto checked = checkOptions(options); !checked) return fail(std::move(checked));
  if (current.others.size() != scene.walkers.size())
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("walkers: found {}, expected {} as in the walk under way", scene.walkers.size(),
                            current.others.size()));
  const bool holds = allArrive(current) && askedAlike(current, options) &&
                     stillHolds(current, frame, scene, floorOf(scene, options));
  if (holds && nothingFreed(current, scene)) return AnytimePlan(keptIn(scene, current));
  std::optional<AnytimePlan::UnderWay> underWay;
  if (holds) underWay = {keptIn(scene, current), frame};
  return AnytimePlan(std::make_unique<Crowd>(prepared(), scene, options, current, frame),
                     std::move(underWay));
}

Prepared WalkPlanner::prepared() const {
  return {*library_, tables_, feet_, sources_, *paces_, standing_};
}

}  // namespace stridegraph
