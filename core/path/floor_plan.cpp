#include "path/floor_plan.h"

#include <algorithm>

#include "base/check.h"

namespace stridegraph {

namespace {

std::vector<Box> boxesOf(const std::vector<Rectangle>& rectangles) {
  std::vector<Box> boxes;
  boxes.reserve(rectangles.size());
  for (const Rectangle& rectangle : rectangles) boxes.push_back(boxOf(rectangle));
  return boxes;
}

}  // namespace

FloorPlan::FloorPlan(const Scene& scene, double radiusMetres)
    : widthMetres_(scene.widthMetres),
      depthMetres_(scene.depthMetres),
      radiusMetres_(radiusMetres),
      obstacles_(scene.obstacles),
      boxes_(boxesOf(obstacles_)),
      grid_(boxes_, {widthMetres_, depthMetres_}, radiusMetres),
      occupancy_(boxes_, {widthMetres_, depthMetres_}, radiusMetres - kTouchToleranceMetres) {
  STRIDEGRAPH_CHECK(radiusMetres > kTouchToleranceMetres);
}

bool FloorPlan::isInsideWalls(const Vec2& point) const {
  const double margin = radiusMetres_ - kTouchToleranceMetres;
  return point.x() >= margin && point.y() >= margin && point.x() <= widthMetres_ - margin &&
         point.y() <= depthMetres_ - margin;
}

bool FloorPlan::isFreeExactly(const Vec2& point) const {
  if (!isInsideWalls(point)) return false;
  const double reach = radiusMetres_ - kTouchToleranceMetres;
  for (const std::uint32_t index : grid_.candidates(point)) {
    if (squaredDistance(boxes_[index], point) < reach * reach) return false;
  }
  return true;
}

void FloorPlan::findBlocked(double z, double stepMetres, std::span<std::uint8_t> blocked) const {
  const std::span<const Occupancy> row = occupancy_.rowUnder(z);
  const double columnsPerStep = stepMetres / occupancy_.cellMetres();
  for (std::size_t i = 0; i < blocked.size(); ++i) {
    const double place = static_cast<double>(i) + 0.5;
    const auto column = static_cast<std::size_t>(place * columnsPerStep);
    const Occupancy occupancy = column < row.size() ? row[column] : Occupancy::kBlocked;
    const bool free = occupancy == Occupancy::kMixed ? isFreeExactly({place * stepMetres, z})
                                                     : occupancy == Occupancy::kFree;
    blocked[i] = free ? 0 : 1;
  }
}

bool FloorPlan::isFree(const Vec2& from, const Vec2& to) const {
  // The room less the margin is convex: with both ends inside, all between is.
  if (!isInsideWalls(from) || !isInsideWalls(to)) return false;
  const double reach = radiusMetres_ - kTouchToleranceMetres;
  return !grid_.anyCellAlong(from, to, [&](std::span<const std::uint32_t> candidates) {
    return std::any_of(candidates.begin(), candidates.end(), [&](std::uint32_t index) {
      return segmentEntersGrownBox(boxes_[index], reach, from, to);
    });
  });
}

double FloorPlan::distanceToNearest(const Vec2& point) const {
  double nearest = std::min({point.x(), point.y(), widthMetres_ - point.x(), depthMetres_ - point.y()});
  if (nearest < 0.0) {
    // Cells cover the room only; a point outside is rare enough for all boxes.
    for (const Box& box : boxes_) nearest = std::min(nearest, signedDistance(box, point));
    return nearest;
  }
  grid_.ringsAround(point, nearest, [&](std::span<const std::uint32_t> candidates) {
    for (const std::uint32_t index : candidates) {
      nearest = std::min(nearest, signedDistance(boxes_[index], point));
    }
    return nearest;
  });
  return nearest;
}

}  // namespace stridegraph
