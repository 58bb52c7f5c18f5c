#include "walk/session.h"

#include <algorithm>

#include "scene/scene_json.h"

namespace stridegraph {
namespace {

/// A walk that still holds is left for another only where that saves this share of what is left to go.
constexpr double kWorthTurning = 0.03;

bool sameRectangle(const Rectangle& a, const Rectangle& b) {
  return a.centre == b.centre && a.size == b.size;
}

bool samePlace(const Placement& a, const Placement& b) {
  return a.position == b.position && a.heading == b.heading;
}

bool sameTrack(const MovingObstacle& a, const MovingObstacle& b) {
  return a.size == b.size && a.repeat == b.repeat &&
         std::equal(a.track.begin(), a.track.end(), b.track.begin(), b.track.end(),
                    [](const TrackPoint& p, const TrackPoint& q) {
                      return p.seconds == q.seconds && p.position == q.position;
                    });
}

bool sameArea(const Area& a, const Area& b) {
  return a.kind == b.kind && sameRectangle(a.rectangle, b.rectangle);
}

bool sameConstraints(const WalkConstraints& a, const WalkConstraints& b) {
  return a.gait == b.gait && a.minSpeedMetresPerSecond == b.minSpeedMetresPerSecond &&
         a.maxSpeedMetresPerSecond == b.maxSpeedMetresPerSecond &&
         a.latestArrivalSeconds == b.latestArrivalSeconds &&
         std::equal(a.areas.begin(), a.areas.end(), b.areas.begin(), b.areas.end(), sameArea);
}

/// Whether all that a walk depends on, but for obstacles that stand still and the starts, is the same.
bool sameTask(const Scene& a, const Scene& b) {
  return a.widthMetres == b.widthMetres && a.depthMetres == b.depthMetres && samePlace(a.goal, b.goal) &&
         a.radiusMetres == b.radiusMetres && a.seed == b.seed &&
         std::equal(a.moving.begin(), a.moving.end(), b.moving.begin(), b.moving.end(), sameTrack) &&
         std::equal(a.walkers.begin(), a.walkers.end(), b.walkers.begin(), b.walkers.end(),
                    [](const Walker& v, const Walker& w) { return samePlace(v.goal, w.goal); }) &&
         sameConstraints(a.constraints, b.constraints);
}

double metresLeft(const Plan& plan, std::size_t frame) {
  double metres = 0.0;
  for (std::size_t f = frame + 1; f < plan.way.size(); ++f)
    metres += (plan.way[f].translation - plan.way[f - 1].translation).norm();
  for (const Plan& other : plan.others) metres += metresLeft(other, frame);
  return metres;
}

bool allArrived(const Plan& plan) {
  return plan.report.status == PlanStatus::kArrived &&
         std::all_of(plan.others.begin(), plan.others.end(), allArrived);
}

bool isFreeFrom(const Plan& plan, std::size_t frame, const FloorPlan& floor) {
  for (std::size_t f = frame; f < plan.way.size(); ++f)
    if (!floor.isFree(plan.way[f].translation)) return false;
  return std::all_of(plan.others.begin(), plan.others.end(),
                     [&](const Plan& other) { return isFreeFrom(other, frame, floor); });
}

}  // namespace

Result<void> WalkSession::plan(const Scene& scene, const PlanOptions& options) {
  Result<Plan> planned = planner_->plan(scene, options);
  if (!planned) return fail(std::move(planned));
  plan_ = std::move(*planned);
  scene_ = scene;
  return {};
}

/// Whether the walk, as it goes on, touches nothing of the scene and leads where that asks.
bool WalkSession::stillHolds(const Scene& scene, std::size_t frame) const {
  return sameTask(scene_, scene) && isFreeFrom(plan_, frame, FloorPlan(scene, plan_.report.radiusMetres));
}

/// Whether every obstacle is still where it was: then no shorter way has opened.
bool WalkSession::nothingFreed(const Scene& scene) const {
  return std::all_of(scene_.obstacles.begin(), scene_.obstacles.end(), [&](const Rectangle& before) {
    return std::any_of(scene.obstacles.begin(), scene.obstacles.end(),
                       [&](const Rectangle& now) { return sameRectangle(before, now); });
  });
}

Result<WalkSession::Following> WalkSession::follow(const Scene& scene, std::size_t frame,
                                                   const PlanOptions& options) {
  if (!allArrived(plan_) || plan_.others.size() != scene.walkers.size()) {
    if (auto planned = plan(scene, options); !planned) return fail(std::move(planned));
    trouble_ = plan_.report;
    return allArrived(plan_) ? Following::kBent : Following::kStuck;
  }
  if (auto checked = checkScene(scene); !checked) return fail(std::move(checked));
  const bool holds = stillHolds(scene, frame);
  if (holds && nothingFreed(scene)) {
    scene_ = scene;
    return Following::kKept;
  }
  Result<Plan> planned = planner_->replan(plan_, frame, scene, options);
  if (!planned) return fail(std::move(planned));
  if (!allArrived(*planned)) {
    trouble_ = std::move(planned->report);
    if (holds) scene_ = scene;
    return holds ? Following::kKept : Following::kStuck;
  }
  const double left = metresLeft(plan_, frame);
  scene_ = scene;
  if (holds && metresLeft(*planned, frame) > (1.0 - kWorthTurning) * left) return Following::kKept;
  plan_ = std::move(*planned);
  return Following::kBent;
}

}  // namespace stridegraph
