#pragma once

#include <string_view>
#include <vector>

#include "figures/svg.h"
#include "math/angle.h"
#include "math/floor_transform.h"
#include "motion/round_body.h"

namespace stridegraph::figures {

/// Looks at the world without perspective.
struct View {
  Vec3 right = Vec3::UnitX();  ///< Unit vectors of the picture in the world,
  Vec3 up = Vec3::UnitY();
  Vec3 toward = Vec3::UnitZ();  ///< the last one at the viewer.
  double pixelsPerMetre = 100.0;
  Vec2 originPixels = Vec2::Zero();  ///< Where the world's origin lies in the picture.

  /// The viewer stands in the direction `from` of what is seen and looks down by `elevation`.
  static View from(Angle from, Angle elevation, double pixelsPerMetre);
  Vec2 at(const Vec3& point) const;
  Vec2 atFloor(const Vec2& point, double heightMetres) const {
    return at({point.x(), heightMetres, point.y()});
  }
};

/// Paints a body of round cones that run softly into each other, lit from above left: an image in the
/// picture, since no SVG shape has such shades. Colour as "#rrggbb".
void drawBody(Svg& svg, const std::vector<Capsule>& body, const View& view, std::string_view colour);

}  // namespace stridegraph::figures
