#include "figures/room_view.h"

#include <algorithm>

#include "figures/palette.h"
#include "path/box.h"

namespace stridegraph::figures {
namespace {

constexpr double kLeftPixels = 52.0;    ///< For numbers and label of z,
constexpr double kBottomPixels = 40.0;  ///< and of x.

PixelBox fitted(const Scene& scene, const PixelBox& within) {
  const double scale = std::min((within.width() - kLeftPixels) / scene.widthMetres,
                                (within.height() - kBottomPixels) / scene.depthMetres);
  const double left = within.left + kLeftPixels;
  return {left, within.top, left + scale * scene.widthMetres, within.top + scale * scene.depthMetres};
}

}  // namespace

RoomView::RoomView(const Scene& scene, const PixelBox& within)
    : scene_(&scene),
      axes_(fitted(scene, within), {0.0, scene.widthMetres, "x (m)"}, {scene.depthMetres, 0.0, "z (m)"}) {}

std::vector<Vec2> RoomView::at(std::span<const Vec2> floorPoints) const {
  std::vector<Vec2> points;
  points.reserve(floorPoints.size());
  for (const Vec2& point : floorPoints) points.push_back(at(point));
  return points;
}

void RoomView::drawRoom(Svg& svg) const {
  const double grow = scene_->radiusMetres * pixelsPerMetre();
  const PixelBox& room = frame();
  svg.beginClip(room);
  svg.rectangle(room, {.fill = palette::kGrown});
  svg.rectangle({room.left + grow, room.top + grow, room.right - grow, room.bottom - grow},
                {.fill = palette::kFloor});
  const auto boxAt = [&](const Rectangle& obstacle, double margin) {
    const Box box = boxOf(obstacle);
    const Vec2 low = at(Vec2(box.minX, box.minZ));
    const Vec2 high = at(Vec2(box.maxX, box.maxZ));
    return PixelBox{low.x() - margin, low.y() - margin, high.x() + margin, high.y() + margin};
  };
  for (const Rectangle& obstacle : scene_->obstacles)
    svg.rectangle(boxAt(obstacle, grow), {.fill = palette::kGrown}, grow);
  for (const Rectangle& obstacle : scene_->obstacles)
    svg.rectangle(boxAt(obstacle, 0.0), {.fill = palette::kBlock});
  svg.endClip();
  axes_.drawFrame(svg);
}

void RoomView::drawEnds(Svg& svg) const {
  drawEnd(svg, scene_->start, palette::kStart);
  drawEnd(svg, scene_->goal, palette::kGoal);
}

void RoomView::drawEnd(Svg& svg, const Placement& placement, std::string_view colour) const {
  const double radius = scene_->radiusMetres * pixelsPerMetre();
  const Vec2 centre = at(placement.position);
  svg.circle(centre, radius, {.fill = colour, .opacity = 0.25});
  svg.circle(centre, radius, {.stroke = colour, .strokePixels = 1.5});
  svg.circle(centre, 2.5, {.fill = colour});
  if (!placement.heading) return;
  const Vec2 tip = centre + radius * Heading::fromAngle(*placement.heading).direction();
  svg.line(centre, tip, {.stroke = colour, .strokePixels = 2.0});
}

double roomHeight(const Scene& scene, double widthPixels) {
  return (widthPixels - kLeftPixels) * scene.depthMetres / scene.widthMetres + kBottomPixels;
}

}  // namespace stridegraph::figures
