#include "walk/keeping.h"

#include <algorithm>
#include <span>

#include "walk/walk_measures.h"

namespace stridegraph {
namespace {

/// Whether all that a walk depends on, but for obstacles that stand still and the starts, is the same.
bool sameTask(const Scene& a, const Scene& b) {
  return a.widthMetres == b.widthMetres && a.depthMetres == b.depthMetres && a.goal == b.goal &&
         a.radiusMetres == b.radiusMetres && a.seed == b.seed && a.moving == b.moving &&
         a.constraints == b.constraints &&
         std::equal(a.walkers.begin(), a.walkers.end(), b.walkers.begin(), b.walkers.end(),
                    [](const Walker& v, const Walker& w) { return v.goal == w.goal; });
}

bool isFreeFrom(const Plan& plan, std::size_t frame, const FloorPlan& floor) {
  for (std::size_t f = frame; f < plan.way.size(); ++f)
    if (!floor.isFree(plan.way[f].translation)) return false;
  return std::all_of(plan.others.begin(), plan.others.end(),
                     [&](const Plan& other) { return isFreeFrom(other, frame, floor); });
}

}  // namespace

bool askedAlike(const Plan& walk, const PlanOptions& options) {
  const PlanOptions& before = walk.options;
  return before.seed == options.seed && before.radiusMetres == options.radiusMetres &&
         before.goalRadiusMetres == options.goalRadiusMetres && before.planner == options.planner &&
         before.search == options.search && before.standing == options.standing &&
         before.footCleanup == options.footCleanup &&
         before.subgoalSpacingMetres == options.subgoalSpacingMetres;
}

bool stillHolds(const Plan& walk, std::size_t frame, const Scene& scene, const FloorPlan& floor) {
  return sameTask(walk.scene, scene) && isFreeFrom(walk, frame, floor);
}

bool nothingFreed(const Plan& walk, const Scene& scene) {
  const std::vector<Rectangle>& now = scene.obstacles;
  return std::all_of(walk.scene.obstacles.begin(), walk.scene.obstacles.end(), [&](const Rectangle& before) {
    return std::find(now.begin(), now.end(), before) != now.end();
  });
}

double metresLeft(const Plan& walk, std::size_t frame) {
  double metres = wayLength(std::span(walk.way).subspan(std::min(frame, walk.way.size())));
  for (const Plan& other : walk.others) metres += metresLeft(other, frame);
  return metres;
}

bool allArrive(const Plan& plan) {
  return plan.report.status == PlanStatus::kArrived &&
         std::all_of(plan.others.begin(), plan.others.end(), allArrive);
}

}  // namespace stridegraph
