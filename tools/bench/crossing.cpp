#include "bench/crossing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace stridegraph::bench {
namespace {

constexpr double kLeastSideMetres = 20.0;
constexpr double kWallMetres = 1.5;  ///< From the circle to the walls.
constexpr double kApartMetres = 2.67;

/// A walker, and where its body is at each frame.
struct Walked {
  const PlanReport* report;
  double straightMetres;
  std::vector<Vec2> places;

  const Vec2& at(std::size_t frame) const { return places[std::min(frame, places.size() - 1)]; }
};

Walked walkedBy(const Walker& walker, const Plan& plan) {
  Walked walked{&plan.report, (walker.goal.position - walker.start.position).norm(), {}};
  for (const FloorTransform& placement : plan.way) walked.places.push_back(placement.translation);
  if (walked.places.empty()) walked.places.push_back(walker.start.position);
  return walked;
}

/// Of the rims of any two at a frame.
double leastGap(const std::vector<Walked>& all, std::size_t frame, double radiusMetres) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < all.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b)
      least = std::min(least, (all[a].at(frame) - all[b].at(frame)).norm() - 2.0 * radiusMetres);
  }
  return least;
}

}  // namespace

Scene crossingScene(std::size_t walkers) {
  const auto count = static_cast<double>(walkers);
  const double radius =
      std::max(0.5 * kLeastSideMetres - kWallMetres, count * kApartMetres / (2.0 * std::numbers::pi));
  Scene scene;
  scene.name = "crossing";
  scene.widthMetres = scene.depthMetres = 2.0 * (radius + kWallMetres);
  const Vec2 middle = Vec2::Constant(radius + kWallMetres);
  for (std::size_t w = 0; w < walkers; ++w) {
    const Angle outward = Angle::degrees(360.0 * static_cast<double>(w) / count);
    const Vec2 arm = radius * Heading::fromAngle(outward).direction();
    scene.walkers.push_back({{middle + arm, outward + Angle::degrees(180.0)}, {middle - arm, std::nullopt}});
  }
  scene.start = scene.walkers.front().start;
  scene.goal = scene.walkers.front().goal;
  scene.walkers.erase(scene.walkers.begin());
  return scene;
}

Crossing crossingOf(const Scene& scene, const Plan& plan) {
  std::vector<Walked> all = {walkedBy({scene.start, scene.goal}, plan)};
  for (std::size_t w = 0; w < scene.walkers.size(); ++w)
    all.push_back(walkedBy(scene.walkers[w], plan.others[w]));
  Crossing crossing;
  std::size_t frames = 0;
  for (const Walked& walked : all) {
    frames = std::max(frames, walked.places.size());
    crossing.slowestMilliseconds = std::max(crossing.slowestMilliseconds, walked.report->totalMilliseconds);
    if (walked.report->status != PlanStatus::kArrived) continue;
    ++crossing.arrived;
    crossing.meanLengthRatio += walked.report->motionLengthMetres / walked.straightMetres;
  }
  if (crossing.arrived > 0) crossing.meanLengthRatio /= static_cast<double>(crossing.arrived);
  crossing.leastGapMetres = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < frames; ++f) {
    const double gap = leastGap(all, f, scene.radiusMetres);
    crossing.leastGapMetres = std::min(crossing.leastGapMetres, gap);
    if (gap < 0.0) ++crossing.contactFrames;
  }
  return crossing;
}

}  // namespace stridegraph::bench
