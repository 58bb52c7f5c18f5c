#include "path/shortest_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "path/connectivity.h"
#include "path/distance_field.h"
#include "path/polyline.h"
#include "path/test_rooms.h"

namespace stridegraph {
namespace {

constexpr double kRadius = 0.4;

std::optional<ShortestPath> shortestIn(const Scene& scene) {
  return shortestPath(FloorPlan(scene, kRadius), scene.start.position, scene.goal.position);
}

void expectFree(const FloorPlan& plan, const std::vector<Vec2>& path) {
  for (std::size_t i = 1; i < path.size(); ++i)
    EXPECT_TRUE(plan.isFree(path[i - 1], path[i])) << "segment " << i;
}

TEST(ShortestPath, isTheStraightLineWhereNothingStandsInTheWay) {
  const auto path = shortestIn(emptyRoom(10.0, 10.0));
  ASSERT_TRUE(path);
  EXPECT_DOUBLE_EQ(path->lengthMetres, 8.0 * std::numbers::sqrt2);
  EXPECT_EQ(path->points.size(), 2U);
}

TEST(ShortestPath, bendsAroundTwoCornersOfABlock) {
  const auto path = shortestIn(roomWithOneBlock());
  ASSERT_TRUE(path);
  const double toCorner = std::hypot(2.0, 1.0);
  const double tangent = std::sqrt(toCorner * toCorner - kRadius * kRadius);
  const double turn = std::atan2(1.0, 2.0) + std::asin(kRadius / toCorner);
  EXPECT_NEAR(path->lengthMetres, 2.0 * tangent + 2.0 * kRadius * turn + 2.0, 1e-5);
}

TEST(ShortestPath, followsArcsWithinAMillimetreAndStaysFree) {
  const Scene scene = roomWithOneBlock();
  const FloorPlan plan(scene, kRadius);
  const auto path = shortestIn(scene);
  ASSERT_TRUE(path);
  expectFree(plan, path->points);
  for (std::size_t i = 1; i + 1 < path->points.size(); ++i) {
    EXPECT_NEAR(plan.clearance(path->points[i]), 0.0, 1.1e-3);
  }
  EXPECT_NEAR(polylineLength(path->points), path->lengthMetres, 2e-3);
}

TEST(ShortestPath, squeezesThroughAGapAsWideAsTheDisc) {
  Scene scene = roomWithGap(2.0 * kRadius);
  scene.start.position = {3.0, 2.0};
  scene.goal.position = {9.0, 2.5};
  const auto path = shortestIn(scene);
  ASSERT_TRUE(path);
  expectFree(FloorPlan(scene, kRadius), path->points);
}

TEST(ShortestPath, isMissingWhenAnEndIsBlockedOrSealed) {
  EXPECT_FALSE(shortestIn(roomWithSealedGoal()));
  Scene scene = roomWithOneBlock();
  scene.goal.position = {5.0, 5.0};
  EXPECT_FALSE(shortestIn(scene));
}

TEST(ShortestPath, agreesWithConnectivityAndTheFieldInRandomRooms) {
  Random random(21);
  int found = 0;
  for (int room = 0; room < 300; ++room) {
    Scene scene = randomRoom(random, 40);
    if (!placeEnds(random, scene, kRadius)) continue;
    const FloorPlan plan(scene, kRadius);
    const auto path = shortestIn(scene);
    ASSERT_EQ(path.has_value(), isConnected(plan, scene.start.position, scene.goal.position))
        << "room " << room;
    if (!path) continue;
    ++found;
    expectFree(plan, path->points);
    EXPECT_NEAR(polylineLength(path->points), path->lengthMetres,
                1e-4 + 2e-3 * static_cast<double>(path->points.size()));
    DistanceField::Params params;
    params.cellMetres = 0.05;
    params.openPath = path->points;
    const double field = DistanceField(plan, scene.goal.position, params).metresToGoal(scene.start.position);
    // Marching is longer by a few per cent, never shorter by more than its cells.
    EXPECT_LT(path->lengthMetres, field + 0.08) << "room " << room;
    EXPECT_GT(1.06 * path->lengthMetres + 0.15, field) << "room " << room;
  }
  EXPECT_GT(found, 80);
}

TEST(ShortestPath, isTheSameInBothDirections) {
  Random random(22);
  for (int room = 0; room < 100; ++room) {
    Scene scene = randomRoom(random, 12);
    if (!placeEnds(random, scene, kRadius)) continue;
    const auto there = shortestIn(scene);
    std::swap(scene.start, scene.goal);
    const auto back = shortestIn(scene);
    ASSERT_EQ(there.has_value(), back.has_value());
    if (there) {
      EXPECT_NEAR(there->lengthMetres, back->lengthMetres, 1e-9);
    }
  }
}

}  // namespace
}  // namespace stridegraph
