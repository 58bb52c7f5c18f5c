#include "path/connectivity.h"

#include <gtest/gtest.h>

#include <vector>

#include "path/test_rooms.h"

namespace stridegraph {
namespace {

constexpr double kRadius = 0.4;

bool connectedIn(const Scene& scene, double radiusMetres = kRadius) {
  return isConnected(FloorPlan(scene, radiusMetres), scene.start.position, scene.goal.position);
}

/// Floods the free cells of a fine grid from the first place; whether it reaches the second.
bool floodReaches(const Scene& scene, double radiusMetres, double cellMetres) {
  const FloorPlan plan(scene, radiusMetres);
  const int columns = static_cast<int>(scene.widthMetres / cellMetres) + 1;
  const int rows = static_cast<int>(scene.depthMetres / cellMetres) + 1;
  std::vector<char> seen(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0);
  const auto nodeAt = [&](const Vec2& point) {
    return static_cast<int>(std::lround(point.y() / cellMetres)) * columns +
           static_cast<int>(std::lround(point.x() / cellMetres));
  };
  std::vector<int> stack;
  const auto visit = [&](int node) {
    const Vec2 point((node % columns) * cellMetres, (node / columns) * cellMetres);
    if (seen[static_cast<std::size_t>(node)] != 0 || !plan.isFree(point)) return;
    seen[static_cast<std::size_t>(node)] = 1;
    stack.push_back(node);
  };
  visit(nodeAt(scene.start.position));
  while (!stack.empty()) {
    const int node = stack.back();
    stack.pop_back();
    // Nodes on the room's edge are never free, so that neighbours always exist.
    for (const int next : {node - 1, node + 1, node - columns, node + columns}) visit(next);
  }
  return seen[static_cast<std::size_t>(nodeAt(scene.goal.position))] != 0;
}

TEST(Connectivity, holdsInAnEmptyRoomAndAroundABlock) {
  EXPECT_TRUE(connectedIn(emptyRoom(10.0, 10.0)));
  EXPECT_TRUE(connectedIn(roomWithOneBlock()));
}

TEST(Connectivity, fallsWhenAnEndIsBlocked) {
  Scene scene = roomWithOneBlock();
  scene.start.position = {5.0, 5.0};
  EXPECT_FALSE(connectedIn(scene));
  scene = roomWithOneBlock();
  scene.goal.position = {0.1, 0.1};
  EXPECT_FALSE(connectedIn(scene));
}

TEST(Connectivity, fallsWhenTheGoalIsSealedAndHoldsInsideTheSeal) {
  Scene scene = roomWithSealedGoal();
  EXPECT_FALSE(connectedIn(scene));
  scene.start.position = {4.0, 4.0};
  EXPECT_TRUE(connectedIn(scene));
}

TEST(Connectivity, dependsOnTheGapToTheMicrometre) {
  EXPECT_TRUE(connectedIn(roomWithGap(0.8)));
  EXPECT_TRUE(connectedIn(roomWithGap(0.8 - 1e-6)));
  EXPECT_FALSE(connectedIn(roomWithGap(0.8 - 3e-6)));
}

TEST(Connectivity, countsGapsBesideTheRoomsWalls) {
  Scene scene = emptyRoom(12.0, 8.0);
  scene.start.position = {3.0, 4.0};
  scene.goal.position = {9.0, 4.0};
  scene.obstacles = {rectangleAt(6.0, 3.6, 0.2, 7.2)};
  EXPECT_TRUE(connectedIn(scene));
  scene.obstacles = {rectangleAt(6.0, 3.61, 0.2, 7.22)};
  EXPECT_FALSE(connectedIn(scene));
}

TEST(Connectivity, holdsForPlacesOnOneLineWithCornersOfObstacles) {
  Scene scene = emptyRoom(12.0, 8.0);
  scene.start.position = {1.0, 4.0};
  scene.goal.position = {11.0, 4.0};
  scene.obstacles = {rectangleAt(4.0, 4.0, 1.0, 1.0), rectangleAt(6.0, 4.5, 1.0, 1.0),
                     rectangleAt(8.0, 3.5, 1.0, 1.0)};
  EXPECT_TRUE(connectedIn(scene));
}

TEST(Connectivity, agreesWithAFineFloodInRandomRooms) {
  constexpr double kCell = 0.02;
  constexpr double kMargin = 0.03;
  Random random(5);
  int connected = 0;
  int parted = 0;
  for (int room = 0; room < 400; ++room) {
    Scene scene = randomRoom(random, 60);
    if (!placeEnds(random, scene, kRadius + 2.0 * kMargin)) continue;
    const bool wide = floodReaches(scene, kRadius + kMargin, kCell);
    const bool narrow = floodReaches(scene, kRadius - kMargin, kCell);
    if (wide != narrow) continue;
    ASSERT_EQ(connectedIn(scene), wide) << "room " << room;
    (wide ? connected : parted) += 1;
  }
  EXPECT_GT(connected, 40);
  EXPECT_GT(parted, 40);
}

}  // namespace
}  // namespace stridegraph
