#include "path/distance_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "path/test_rooms.h"

namespace stridegraph {
namespace {

constexpr double kRadius = 0.4;

TEST(DistanceField, isNearlyTheStraightLineInAnEmptyRoom) {
  const FloorPlan plan(emptyRoom(20.0, 15.0), kRadius);
  const Vec2 goal(13.0, 4.0);
  const DistanceField field(plan, goal);
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    const Vec2 point(random.uniform(0.4, 19.6), random.uniform(0.4, 14.6));
    const double exact = (point - goal).norm();
    EXPECT_NEAR(field.metresToGoal(point), exact, 0.03 + 0.015 * exact);
  }
  EXPECT_EQ(field.metresToGoal(goal), 0.0);
}

TEST(DistanceField, goesAroundAWall) {
  // From (2, 5) to (8, 5) the shortest way touches the rounded corners at (4, 4) and (6, 4).
  const Scene scene = roomWithOneBlock();
  const FloorPlan plan(scene, kRadius);
  const DistanceField field(plan, scene.goal.position);
  const double toCorner = std::hypot(2.0, 1.0);
  const double tangent = std::sqrt(toCorner * toCorner - kRadius * kRadius);
  const double turn = std::atan2(1.0, 2.0) + std::asin(kRadius / toCorner);
  const double exact = 2.0 * tangent + 2.0 * kRadius * turn + 2.0;
  EXPECT_GT(field.metresToGoal(scene.start.position), exact - 0.01);
  EXPECT_LT(field.metresToGoal(scene.start.position), 1.05 * exact);
}

TEST(DistanceField, isInfiniteWhereTheGoalIsSealedOffOrBlocked) {
  const Scene sealed = roomWithSealedGoal();
  const FloorPlan plan(sealed, kRadius);
  const DistanceField field(plan, sealed.goal.position);
  EXPECT_TRUE(std::isinf(field.metresToGoal(sealed.start.position)));
  EXPECT_TRUE(std::isfinite(field.metresToGoal({5.5, 5.5})));
  const DistanceField blocked(plan, {3.0, 5.0});
  EXPECT_TRUE(std::isinf(blocked.metresToGoal(sealed.start.position)));
}

TEST(DistanceField, isFiniteAtEveryFreePointBesideReachedCells) {
  Random random(3);
  for (int room = 0; room < 30; ++room) {
    const Scene scene = randomRoom(random, 8);
    const FloorPlan plan(scene, kRadius);
    const Vec2 goal = randomPoint(random, scene);
    if (!plan.isFree(goal)) continue;
    const DistanceField field(plan, goal);
    for (int i = 0; i < 300; ++i) {
      // A point in sight of the goal and as near to an obstacle as allowed is reached, whatever the cells
      // say.
      const Vec2 point = randomPoint(random, scene);
      if (!plan.isFree(point, goal)) continue;
      ASSERT_TRUE(std::isfinite(field.metresToGoal(point)));
      ASSERT_GT(field.metresToGoal(point), 0.98 * (point - goal).norm() - 0.02);
    }
  }
}

TEST(DistanceField, followsAKnownPathThroughAGapItsCellsCannotSee) {
  const Scene scene = roomWithGap(2.0 * kRadius + 0.01);
  const FloorPlan plan(scene, kRadius);
  DistanceField::Params params;
  params.cellMetres = 0.15;
  EXPECT_TRUE(
      std::isinf(DistanceField(plan, scene.goal.position, params).metresToGoal(scene.start.position)));
  params.openPath = {scene.start.position, scene.goal.position};
  const double metres = DistanceField(plan, scene.goal.position, params).metresToGoal(scene.start.position);
  EXPECT_NEAR(metres, 6.0, 0.4);
}

TEST(DistanceField, pointsTowardsTheGoalAndAroundTheBlock) {
  const Scene scene = roomWithOneBlock();
  const FloorPlan plan(scene, kRadius);
  const DistanceField field(plan, scene.goal.position);
  EXPECT_GT(field.directionToGoal({7.0, 5.0}).x(), 0.99);
  EXPECT_GT(field.directionToGoal({5.0, 3.5}).x(), 0.9);
  EXPECT_EQ(field.directionToGoal({5.0, 5.0}), Vec2::Zero());
}

TEST(DistanceField, givesDistanceAndDirectionAtOnceAsItDoesApart) {
  const Scene scene = roomWithOneBlock();
  const FloorPlan plan(scene, kRadius);
  const DistanceField field(plan, scene.goal.position);
  Random random(5);
  int compared = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec2 point = randomPoint(random, scene);
    const DistanceField::Sample sample = field.at(point);
    if (!plan.isFree(point)) continue;
    EXPECT_NEAR(sample.metres, field.metresToGoal(point), 1e-9);
    if (plan.clearance(point) < 0.3 || sample.metres < 0.5) continue;
    EXPECT_GT(sample.direction.dot(field.directionToGoal(point)), 0.9);
    ++compared;
  }
  EXPECT_GT(compared, 100);
}

TEST(DistanceField, choosesCoarserCellsInVastRoomsAndFinerOnesForSmallDiscs) {
  EXPECT_DOUBLE_EQ(DistanceField(FloorPlan(emptyRoom(20.0, 20.0), 0.4), {5.0, 5.0}).cellMetres(), 0.1);
  EXPECT_DOUBLE_EQ(DistanceField(FloorPlan(emptyRoom(40.0, 40.0), 0.4), {5.0, 5.0}).cellMetres(), 0.1);
  EXPECT_DOUBLE_EQ(DistanceField(FloorPlan(emptyRoom(80.0, 80.0), 0.4), {5.0, 5.0}).cellMetres(), 0.2);
  EXPECT_DOUBLE_EQ(DistanceField(FloorPlan(emptyRoom(150.0, 150.0), 0.4), {5.0, 5.0}).cellMetres(), 0.25);
  EXPECT_DOUBLE_EQ(DistanceField(FloorPlan(emptyRoom(10.0, 10.0), 0.05), {5.0, 5.0}).cellMetres(), 0.05);
}

TEST(DistanceField, leadsFromCellToCellDownToTheGoal) {
  const Scene scene = roomWithOneBlock();
  const FloorPlan plan(scene, kRadius);
  const DistanceField field(plan, scene.goal.position);
  const std::vector<Vec2> way = field.cellsToGoal(scene.start.position);
  ASSERT_GT(way.size(), 10U);
  EXPECT_LT((way.front() - scene.start.position).norm(), field.cellMetres());
  EXPECT_LT((way.back() - scene.goal.position).norm(), field.cellMetres());
  for (std::size_t i = 0; i < way.size(); ++i) {
    EXPECT_TRUE(plan.isFree(way[i]));
    if (i == 0) continue;
    EXPECT_LT((way[i] - way[i - 1]).norm(), 1.5 * field.cellMetres());
    EXPECT_LE(field.metresToGoal(way[i]), field.metresToGoal(way[i - 1]));
  }
}

TEST(DistanceField, leadsNowhereFromWhereTheGoalCannotBeReached) {
  const Scene scene = roomWithSealedGoal();
  const DistanceField field(FloorPlan(scene, kRadius), scene.goal.position);
  EXPECT_TRUE(field.cellsToGoal(scene.start.position).empty());
  EXPECT_EQ(field.goal(), scene.goal.position);
}

}  // namespace
}  // namespace stridegraph
