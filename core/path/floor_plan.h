#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "math/types.h"
#include "path/box.h"
#include "path/occupancy_map.h"
#include "path/rectangle_grid.h"
#include "scene/scene.h"

namespace stridegraph {

/// The room as a disc of one radius sees it: everything that stands still, exactly (disc against rectangles
/// and against the room's four walls). A position is free when the disc there touches nothing by more than
/// kTouchToleranceMetres.
class FloorPlan {
 public:
  static constexpr double kTouchToleranceMetres = 1e-6;

  /// Prepares the tests below: about 1 ms for a 40 m room. The scene must have passed checkScene;
  /// radiusMetres > kTouchToleranceMetres. Moving obstacles do not count.
  FloorPlan(const Scene& scene, double radiusMetres);

  double widthMetres() const { return widthMetres_; }
  double depthMetres() const { return depthMetres_; }
  double radiusMetres() const { return radiusMetres_; }
  const std::vector<Rectangle>& obstacles() const { return obstacles_; }
  /// The same rectangles, in the same order, by their corners.
  const std::vector<Box>& boxes() const { return boxes_; }
  /// Which of them lie within the disc's radius of each cell.
  const RectangleGrid& grid() const { return grid_; }

  /// Distance of a point to the nearest rectangle or wall, metres; negative inside a rectangle or outside the
  /// room.
  double distanceToNearest(const Vec2& point) const;
  /// Distance of the disc's rim to the nearest thing: distanceToNearest - radius.
  double clearance(const Vec2& point) const { return distanceToNearest(point) - radiusMetres_; }
  /// Whether the disc may stand there. A table look-up in most places.
  bool isFree(const Vec2& point) const {
    const Occupancy occupancy = occupancy_.at(point);
    return occupancy == Occupancy::kMixed ? isFreeExactly(point) : occupancy == Occupancy::kFree;
  }
  /// The same for a row of points (i + 0.5) stepMetres, z: blocked[i] becomes 1 where the disc may not stand,
  /// else 0. 0 <= z.
  void findBlocked(double z, double stepMetres, std::span<std::uint8_t> blocked) const;
  /// Whether the disc may move from one point to the other in a straight line, ends included.
  bool isFree(const Vec2& from, const Vec2& to) const;

 private:
  bool isFreeExactly(const Vec2& point) const;
  bool isInsideWalls(const Vec2& point) const;

  double widthMetres_;
  double depthMetres_;
  double radiusMetres_;
  std::vector<Rectangle> obstacles_;
  std::vector<Box> boxes_;
  RectangleGrid grid_;
  OccupancyMap occupancy_;
};

}  // namespace stridegraph
