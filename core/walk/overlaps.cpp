#include "walk/overlaps.h"

#include <fmt/format.h>

#include <utility>

#include "path/box.h"
#include "scene/track.h"
#include "walk/traffic.h"

namespace stridegraph {
namespace {

using Refusals = std::vector<std::optional<Refusal>>;

void refuse(std::optional<Refusal>& refusal, PlanStatus status, const std::string& why) {
  if (!refusal) {
    refusal = Refusal{status, why};
  } else if (refusal->status == status) {
    refusal->explanation += "; " + why;
  }
}

/// How near the rim of a disc is to a rectangle, metres; negative where it reaches into it.
double rimDistance(const Rectangle& rectangle, const Vec2& middle, double radius) {
  return signedDistance(boxOf(rectangle), middle) - radius;
}

void refuseStarts(const Overlaps& overlaps, const std::vector<Beginner>& walkers, Refusals& refusals) {
  const double needed = 2.0 * overlaps.radiusMetres + Traffic::kMarginMetres;
  for (std::size_t a = 0; a < walkers.size(); ++a) {
    for (std::size_t b = a + 1; b < walkers.size(); ++b) {
      const double apart = (walkers[a].walker.start.position - walkers[b].walker.start.position).norm();
      if (!walkers[a].begins || !walkers[b].begins || apart >= needed) continue;
      const std::string why =
          fmt::format("walkers {} and {} start {:.2f} m apart, and bodies of radius {:.2f} m need {:.2f} m",
                      a + 1, b + 1, apart, overlaps.radiusMetres, needed);
      refuse(refusals[a], PlanStatus::kStartBlocked, why);
      refuse(refusals[b], PlanStatus::kStartBlocked, why);
    }
  }
}

void refuseInObstacles(const Overlaps& overlaps, const std::vector<Beginner>& walkers, Refusals& refusals) {
  for (std::size_t w = 0; w < walkers.size(); ++w) {
    for (std::size_t m = 0; m < overlaps.scene.moving.size(); ++m) {
      const double rim = rimDistance(rectangleAt(overlaps.scene.moving[m], 0.0),
                                     walkers[w].walker.start.position, overlaps.radiusMetres);
      if (!walkers[w].begins || rim >= 0.0) continue;
      refuse(refusals[w], PlanStatus::kStartBlocked,
             fmt::format(
                 "moving block {} is at the start of walker {} when the walk begins: it reaches {:.2f} m "
                 "into the body's disc of radius {:.2f} m",
                 m + 1, w + 1, -rim, overlaps.radiusMetres));
    }
  }
}

/// Whether a walker begins, and its walk ends, nearer to a place than this.
bool staysNear(const Beginner& walker, const Vec2& place, double metres) {
  return walker.begins && (walker.walker.start.position - place).norm() < metres &&
         (walker.walker.goal.position - place).norm() < metres;
}

void refuseGoals(const Overlaps& overlaps, const std::vector<Beginner>& walkers, Refusals& refusals) {
  const double needed = 2.0 * overlaps.radiusMetres + Traffic::kMarginMetres;
  const double least = needed - overlaps.goalRadiusMetres;
  for (std::size_t b = 0; b < walkers.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      const Vec2& goal = walkers[a].walker.goal.position;
      const double apart = (goal - walkers[b].walker.goal.position).norm();
      // Who is refused does not come to its goal.
      if (refusals[a] || apart >= least) continue;
      // Who is there from the beginning stays.
      const bool laterStays = !refusals[b] && staysNear(walkers[b], goal, least);
      refuse(
          refusals[laterStays ? a : b], PlanStatus::kGoalBlocked,
          fmt::format("the goals of walkers {} and {} are {:.2f} m apart, and bodies of radius {:.2f} m need "
                      "{:.2f} m: walker {} stays there",
                      a + 1, b + 1, apart, overlaps.radiusMetres, needed, (laterStays ? b : a) + 1));
    }
  }
}

}  // namespace

std::vector<std::optional<Refusal>> Overlaps::refusals(const std::vector<Beginner>& walkers) const {
  Refusals refusals(walkers.size());
  refuseStarts(*this, walkers, refusals);
  refuseInObstacles(*this, walkers, refusals);
  refuseGoals(*this, walkers, refusals);
  return refusals;
}

}  // namespace stridegraph
