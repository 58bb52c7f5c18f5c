#pragma once

#include "math/random.h"
#include "path/floor_plan.h"
#include "scene/scene.h"

namespace stridegraph {

/// A room with nothing in it; start and goal near opposite corners.
inline Scene emptyRoom(double widthMetres, double depthMetres) {
  Scene scene;
  scene.widthMetres = widthMetres;
  scene.depthMetres = depthMetres;
  scene.start.position = {1.0, 1.0};
  scene.goal.position = {widthMetres - 1.0, depthMetres - 1.0};
  return scene;
}

inline Rectangle rectangleAt(double x, double z, double widthMetres, double depthMetres) {
  return {{x, z}, {widthMetres, depthMetres}};
}

/// A 10 x 10 m room, a 2 x 2 m block in its middle (4..6), from (2, 5) to (8, 5).
inline Scene roomWithOneBlock() {
  Scene scene = emptyRoom(10.0, 10.0);
  scene.obstacles.push_back(rectangleAt(5.0, 5.0, 2.0, 2.0));
  scene.start.position = {2.0, 5.0};
  scene.goal.position = {8.0, 5.0};
  return scene;
}

/// A 12 x 8 m room cut in two at x = 6 by a wall 0.2 m thick with a gap of the given width around z = 4.
inline Scene roomWithGap(double gapMetres) {
  Scene scene = emptyRoom(12.0, 8.0);
  const double wall = 0.5 * (8.0 - gapMetres);
  scene.obstacles.push_back(rectangleAt(6.0, 0.5 * wall, 0.2, wall));
  scene.obstacles.push_back(rectangleAt(6.0, 8.0 - 0.5 * wall, 0.2, wall));
  scene.start.position = {3.0, 4.0};
  scene.goal.position = {9.0, 4.0};
  return scene;
}

/// The goal at (5, 5) in a closed box of four walls, the start outside it.
inline Scene roomWithSealedGoal() {
  Scene scene = emptyRoom(12.0, 12.0);
  scene.obstacles = {rectangleAt(5.0, 3.0, 4.4, 0.4), rectangleAt(5.0, 7.0, 4.4, 0.4),
                     rectangleAt(3.0, 5.0, 0.4, 4.4), rectangleAt(7.0, 5.0, 0.4, 4.4)};
  scene.start.position = {10.0, 10.0};
  scene.goal.position = {5.0, 5.0};
  return scene;
}

/// A room of 6 to 14 m with up to `mostRectangles` rectangles anywhere, some partly outside.
inline Scene randomRoom(Random& random, std::uint64_t mostRectangles) {
  Scene scene = emptyRoom(random.uniform(6.0, 14.0), random.uniform(6.0, 14.0));
  const std::uint64_t count = random.below(mostRectangles + 1);
  for (std::uint64_t i = 0; i < count; ++i) {
    const double x = random.uniform(-0.5, scene.widthMetres + 0.5);
    const double z = random.uniform(-0.5, scene.depthMetres + 0.5);
    const bool wall = random.below(3) == 0;
    const double width = random.uniform(0.2, wall ? 6.0 : 1.8);
    scene.obstacles.push_back(rectangleAt(x, z, width, wall ? 0.3 : random.uniform(0.2, 2.5)));
  }
  return scene;
}

inline Vec2 randomPoint(Random& random, const Scene& scene) {
  const double x = random.uniform(0.0, scene.widthMetres);
  return {x, random.uniform(0.0, scene.depthMetres)};
}

/// Start and goal anywhere free for a disc of this radius; false where 50 tries do not find both.
inline bool placeEnds(Random& random, Scene& scene, double radiusMetres) {
  const FloorPlan plan(scene, radiusMetres);
  for (Placement* end : {&scene.start, &scene.goal}) {
    int tries = 0;
    do {
      end->position = randomPoint(random, scene);
    } while (!plan.isFree(end->position) && ++tries < 50);
    if (tries == 50) return false;
  }
  return true;
}

}  // namespace stridegraph
