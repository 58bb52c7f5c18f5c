#include "walk/cost_to_go.h"

#include <gtest/gtest.h>

#include <cmath>

#include "walk/search_tables.h"
#include "walk/test_library.h"

namespace stridegraph {
namespace {

constexpr double kRadius = 0.4;

class CostToGoTest : public ::testing::Test {
 protected:
  MotionLibrary library = testing::threeArcs();
  SearchTables tables{library};
  Vec2 goal{18.0, 5.0};

  /// A room of 20 x 10 m with a wall across it that leaves a gap at its far end, if asked for.
  FloorPlan room(bool wall) const {
    Scene scene;
    scene.widthMetres = 20.0;
    scene.depthMetres = 10.0;
    if (wall) scene.obstacles = {{{10.0, 4.0}, {1.0, 8.0}}};
    return FloorPlan(scene, kRadius);
  }

  double at(const FloorPlan& plan, const Vec2& place, double degrees) const {
    const DistanceField field(plan, goal);
    CostToGo costToGo(tables.steering, field, {20.0, 10.0});
    return costToGo.metres(0, {place, Heading::fromAngle(Angle::degrees(degrees))});
  }
};

TEST_F(CostToGoTest, isTheStraightWalksCostWhereNothingIsInTheWay) {
  EXPECT_NEAR(at(room(false), {4.0, 5.0}, 90.0), tables.steering.costPerMetre() * 14.0, 0.3);
}

TEST_F(CostToGoTest, isMoreForABodyThatFacesAway) {
  const FloorPlan plan = room(false);
  EXPECT_GT(at(plan, {4.0, 5.0}, 180.0), at(plan, {4.0, 5.0}, 90.0) + 0.3);
  EXPECT_GT(at(plan, {4.0, 5.0}, 270.0), at(plan, {4.0, 5.0}, 180.0));
}

TEST_F(CostToGoTest, countsTheTurnsOfTheWayAhead) {
  const FloorPlan plan = room(true);
  const DistanceField field(plan, goal);
  const Vec2 place(4.0, 5.0);
  const double way = field.metresToGoal(place);
  const Vec2 direction = field.directionToGoal(place);
  const double facing = Heading{direction.x(), direction.y()}.angle().degrees();
  // About 35 degrees up to the gap, and 50 and more down again behind it.
  const double turns = at(plan, place, facing) - tables.steering.costPerMetre() * way;
  EXPECT_GT(turns, 0.25);
  EXPECT_LT(turns, 1.0);
}

TEST_F(CostToGoTest, isInfiniteWhereTheGoalCannotBeReached) {
  Scene scene;
  scene.widthMetres = 20.0;
  scene.depthMetres = 10.0;
  scene.obstacles = {{{10.0, 5.0}, {1.0, 10.0}}};
  EXPECT_TRUE(std::isinf(at(FloorPlan(scene, kRadius), {4.0, 5.0}, 90.0)));
}

TEST_F(CostToGoTest, doesNotDependOnTheOrderOfQuestions) {
  const FloorPlan plan = room(true);
  const DistanceField field(plan, goal);
  CostToGo forwards(tables.steering, field, {20.0, 10.0});
  CostToGo backwards(tables.steering, field, {20.0, 10.0});
  std::vector<FloorTransform> places;
  for (int i = 0; i < 60; ++i) {
    places.push_back({{1.0 + 0.3 * i, 1.0 + 0.13 * i}, Heading::fromAngle(Angle::degrees(11.0 * i))});
  }
  std::vector<double> first;
  for (const FloorTransform& place : places) first.push_back(forwards.metres(1, place));
  for (std::size_t i = places.size(); i-- > 0;) EXPECT_EQ(backwards.metres(1, places[i]), first[i]);
}

}  // namespace
}  // namespace stridegraph
