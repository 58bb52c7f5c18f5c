#include "walk/keeping.h"

#include <algorithm>

#include "path/floor_plan.h"

namespace stridegraph {
namespace {

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

bool isFreeFrom(const Plan& plan, std::size_t frame, const FloorPlan& floor) {
  for (std::size_t f = frame; f < plan.way.size(); ++f)
    if (!floor.isFree(plan.way[f].translation)) return false;
  return std::all_of(plan.others.begin(), plan.others.end(),
                     [&](const Plan& other) { return isFreeFrom(other, frame, floor); });
}

}  // namespace

bool stillHolds(const Plan& walk, std::size_t frame, const Scene& scene) {
  return sameTask(walk.scene, scene) && isFreeFrom(walk, frame, FloorPlan(scene, walk.report.radiusMetres));
}

bool nothingFreed(const Plan& walk, const Scene& scene) {
  return std::all_of(walk.scene.obstacles.begin(), walk.scene.obstacles.end(), [&](const Rectangle& before) {
    return std::any_of(scene.obstacles.begin(), scene.obstacles.end(),
                       [&](const Rectangle& now) { return sameRectangle(before, now); });
  });
}

double metresLeft(const Plan& walk, std::size_t frame) {
  double metres = 0.0;
  for (std::size_t f = frame + 1; f < walk.way.size(); ++f)
    metres += (walk.way[f].translation - walk.way[f - 1].translation).norm();
  for (const Plan& other : walk.others) metres += metresLeft(other, frame);
  return metres;
}

bool allArrive(const Plan& plan) {
  return plan.report.status == PlanStatus::kArrived &&
         std::all_of(plan.others.begin(), plan.others.end(), allArrive);
}

}  // namespace stridegraph
