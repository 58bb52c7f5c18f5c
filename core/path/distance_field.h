#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "math/types.h"
#include "path/floor_plan.h"

namespace stridegraph {

/// How far the disc has to go to the goal, around the obstacles, from anywhere in the room: the eikonal
/// equation solved by fast marching, first order (Sethian 1996), on a grid of square cells. A few per cent
/// above the exact distance at most places, since first-order marching rounds corners widely.
class DistanceField {
 public:
  struct Params {
    /// Side of a cell; 0 chooses: 0.1 m, in rooms above 1,600 m2 so large that there are 160,000 cells, up to
    /// 0.25 m, never above the disc's radius, coarser again where there would be more than 4 million cells.
    double cellMetres = 0.0;
    /// Cells this near to the goal and in its sight start with their exact distance.
    double exactRadiusMetres = 0.5;
    /// A path known to be free, for instance the planner's: its cells count as open even where the grid is
    /// too coarse to see the gap. May be empty.
    std::vector<Vec2> openPath;
    /// How many metres a metre counts for at a place, 1..100; null where all count the same. Values are then
    /// weighted metres.
    std::function<double(const Vec2&)> weight;
  };

  DistanceField(const FloorPlan& plan, const Vec2& goal) : DistanceField(plan, goal, Params{}) {}
  DistanceField(const FloorPlan& plan, const Vec2& goal, const Params& params);

  /// Metres from the point to the goal, bilinear between cells; beside walls the smallest of the neighbouring
  /// cells' values plus the way there. Infinite where the goal cannot be reached: there, and never where the
  /// disc is free and a cell within two cells is reached. A point inside an obstacle may get either.
  double metresToGoal(const Vec2& point) const;

  /// Unit direction in which the distance falls fastest; zero at the goal and where it is infinite.
  Vec2 directionToGoal(const Vec2& point) const;

  /// Both at once: metresToGoal(), and the direction by which its bilinear values fall; directionToGoal()
  /// beside walls.
  struct Sample {
    double metres = 0.0;
    Vec2 direction = Vec2::Zero();
  };
  Sample at(const Vec2& point) const;

  /// Middles of cells from the point's to the goal's, each next to the one before and nearer to the goal: a
  /// way for the eye, not for the disc. Empty where the distance is infinite.
  std::vector<Vec2> cellsToGoal(const Vec2& point) const;

  const Vec2& goal() const { return goal_; }
  double cellMetres() const { return cellMetres_; }
  std::size_t cellCount() const { return values_.size(); }

 private:
  struct Marching;

  /// The middle of a cell; columns and rows count from 1, since a ring of walls surrounds the grid.
  Vec2 centreOf(std::size_t column, std::size_t row) const {
    return {(static_cast<double>(column) - 0.5) * cellMetres_,
            (static_cast<double>(row) - 0.5) * cellMetres_};
  }
  std::size_t indexOf(std::size_t column, std::size_t row) const { return row * stride_ + column; }
  std::size_t cellUnder(const Vec2& point) const;
  void openFreeCells(const FloorPlan& plan);
  void openCellsAlong(const std::vector<Vec2>& path);
  void weighCells(const std::function<double(const Vec2&)>& weight, Marching& marching) const;
  void seedAroundGoal(const FloorPlan& plan, double exactRadiusMetres, Marching& marching);
  void march(Marching& marching);
  double nearbyMetres(const Vec2& point, int reach) const;
  std::size_t lowestAround(std::size_t cell, std::size_t reach) const;

  Vec2 goal_;
  double cellMetres_;
  double inverseCell_;
  std::size_t columns_;
  std::size_t rows_;
  std::size_t stride_;         ///< columns_ + 2.
  std::vector<float> values_;  ///< (columns_ + 2) x (rows_ + 2), row by row; infinite where not reached.
};

}  // namespace stridegraph
