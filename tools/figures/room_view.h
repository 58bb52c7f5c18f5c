#pragma once

#include <span>
#include <vector>

#include "figures/axes.h"
#include "figures/svg.h"
#include "math/floor_transform.h"
#include "scene/scene.h"

namespace stridegraph::figures {

/// A room from above: x to the right and z downwards, as one looks down on it.
class RoomView {
 public:
  /// As large as fits into the box, at its top left.
  RoomView(const Scene& scene, const PixelBox& within);

  const PixelBox& frame() const { return axes_.frame(); }
  Vec2 at(const Vec2& floorPoint) const { return axes_.at(floorPoint.x(), floorPoint.y()); }
  std::vector<Vec2> at(std::span<const Vec2> floorPoints) const;
  double pixelsPerMetre() const { return axes_.pixelsPerX(); }

  /// Floor, what the middle of a disc of the scene's radius cannot enter, blocks and axes.
  void drawRoom(Svg& svg) const;
  /// Discs at start and goal, with the headings asked for.
  void drawEnds(Svg& svg) const;

 private:
  void drawEnd(Svg& svg, const Placement& placement, std::string_view colour) const;

  const Scene* scene_;
  Axes axes_;
};

/// Height in pixels that a room takes at a width, its axes included.
double roomHeight(const Scene& scene, double widthPixels);

}  // namespace stridegraph::figures
