#include "plan_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "target.h"
#include "text_checks.h"

namespace stridegraph::fuzz {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// From a point to a rectangle; 0 inside, where the floor plan says how deep.
double distanceTo(const Rectangle& rectangle, const Vec2& point) {
  const double x = std::abs(point.x() - rectangle.centre.x()) - rectangle.size.x() / 2.0;
  const double z = std::abs(point.y() - rectangle.centre.y()) - rectangle.size.y() / 2.0;
  return std::hypot(std::max(x, 0.0), std::max(z, 0.0));
}

/// From a point to whatever stands, worked out without the floor plan.
double distanceToNearest(const Scene& scene, const Vec2& point) {
  double least =
      std::min({point.x(), point.y(), scene.widthMetres - point.x(), scene.depthMetres - point.y()});
  for (const Rectangle& rectangle : scene.obstacles) least = std::min(least, distanceTo(rectangle, point));
  return least;
}

void requireFiniteFrames(const Clip& walk, double rotationTolerance) {
  require(walk.rotations.size() == walk.frameCount() * walk.jointCount, "each frame turns each joint");
  for (const Vec3& root : walk.rootPositions) require(root.allFinite(), "the root of a walk is somewhere");
  for (const Quat& rotation : walk.rotations)
    require(std::abs(rotation.norm() - 1.0) < rotationTolerance, "rotations of a walk are of unit length");
}

void requireAgreement(const Plan& plan) {
  const PlanReport& report = plan.report;
  const std::size_t frames = plan.walk.frameCount();
  require(frames > 0, "who arrives has walked");
  require(report.frames == frames, "the report counts the walk's frames");
  require(plan.frameKinds.size() == frames && plan.contacts.size() == frames && plan.way.size() == frames,
          "what goes with frames is there for each of them");
  require(plan.unbentWay.empty() || plan.unbentWay.size() == frames, "the unbent way has the walk's frames");
  require(
      std::abs(report.durationSeconds - static_cast<double>(frames - 1) / plan.walk.framesPerSecond) < 1e-9,
      "the report's duration is the walk's");
  require(report.transitions == report.seams.size() && report.transitions <= report.edges.size(),
          "each transition is a seam and an edge");
  for (const WalkSeam& seam : report.seams) require(seam.frame < frames, "seams lie within the walk");
  require(report.jointSpeed.frame < frames && report.jointAcceleration.frame < frames,
          "the hardest frames lie within the walk");
}

/// The disc of a walk against everything that stands, and against what the report says of that.
void requireClearance(const Plan& plan, const Scene& scene) {
  const double radius = plan.report.radiusMetres;
  double least = kInfinity;
  for (const Vec3& root : plan.walk.rootPositions)
    least = std::min(least, distanceToNearest(scene, {root.x(), root.z()}) - radius);
  const double told = plan.report.clearanceMetres;
  const bool isInside = least <= -radius;
  require(isInside ? told <= least + 1e-6 : std::abs(told - least) < 1e-6,
          "the report's clearance is the walk's");
  if (plan.report.search != SearchKind::kThesis)
    require(least >= -1e-5, "the disc touches nothing that stands: " + std::to_string(least));
}

void requireEnds(const Plan& plan, const Placement& start, const Placement& goal) {
  const Vec3& first = plan.walk.rootPositions.front();
  const Vec3& last = plan.walk.rootPositions.back();
  require((Vec2(first.x(), first.z()) - start.position).norm() < 1e-6, "a walk begins at the start");
  const double miss = (Vec2(last.x(), last.z()) - goal.position).norm();
  require(std::abs(miss - plan.report.arrivalErrorMetres) < 1e-6,
          "the report says how near the goal a walk ends");
  require(miss <= plan.report.goalRadiusMetres + 1e-6, "who arrives is within the goal's radius");
}

/// All numbers of a report are numbers: JSON has no others, and null stands for them.
void requireNumbers(const nlohmann::json& json) {
  require(!json.is_null(), "a report holds real numbers");
  if (!json.is_structured()) return;
  for (const auto& member : json) requireNumbers(member);
}

void requireSoundWalker(const Plan& plan, const Scene& scene, const Walker& walker,
                        double rotationTolerance) {
  const PlanReport& report = plan.report;
  const nlohmann::json json = nlohmann::json::parse(toJson(report), nullptr, false);
  require(!json.is_discarded(), "a report is JSON");
  requireNumbers(json);
  if (!report.explanation.empty()) requireSentence(report.explanation);
  if (report.status != PlanStatus::kArrived) {
    require(!report.explanation.empty(), "who does not arrive says why");
    require(plan.walk.frameCount() == 0, "who does not arrive has no walk");
    return;
  }
  requireFiniteFrames(plan.walk, rotationTolerance);
  requireAgreement(plan);
  requireClearance(plan, scene);
  requireEnds(plan, walker.start, walker.goal);
  if (report.movingClearanceMetres && *report.movingClearanceMetres < 0.0)
    require(!report.explanation.empty(), "a walk into something that moves says so");
}

}  // namespace

void requireSound(const Plan& plan, const Scene& scene, double rotationTolerance) {
  require(plan.others.size() == scene.walkers.size(), "each walker has a plan");
  requireSoundWalker(plan, scene, {scene.start, scene.goal}, rotationTolerance);
  for (std::size_t i = 0; i < plan.others.size(); ++i)
    requireSoundWalker(plan.others[i], scene, scene.walkers[i], rotationTolerance);
  require(nlohmann::json::accept(toJson(plan)), "a report of several walkers is JSON");
}

MillisecondClock countingClock() {
  return [milliseconds = std::make_shared<double>(0.0)] { return *milliseconds += 1.0; };
}

}  // namespace stridegraph::fuzz
