#include "walk/arrival_warp.h"

#include <gtest/gtest.h>

#include "math/rotation.h"

namespace stridegraph {
namespace {

constexpr double kStepMetres = 0.04;

/// Six metres along +x, then a second of standing.
std::vector<FloorTransform> straightWay() {
  std::vector<FloorTransform> way;
  for (int f = 0; f <= 150; ++f)
    way.push_back({{2.0 + kStepMetres * f, 6.0}, Heading::fromAngle(Angle::degrees(90))});
  for (int f = 0; f < 30; ++f) way.push_back(way.back());
  return way;
}

FloorPlan openRoom() {
  Scene scene;
  return FloorPlan(scene, 0.4);
}

/// Largest relative change of a step and largest turn for each metre.
ArrivalWarp measured(const std::vector<FloorTransform>& way) {
  ArrivalWarp most;
  for (std::size_t f = 1; f < way.size(); ++f) {
    const FloorTransform step = way[f - 1].inverse() * way[f];
    const double length = step.translation.norm();
    if (length < 1e-9) {
      EXPECT_NEAR(step.heading.cos, 1.0, 1e-12);
      continue;
    }
    most.stretch = std::max(most.stretch, std::abs(length / kStepMetres - 1.0));
    const double turn = std::abs(step.heading.angle().radians()) / kStepMetres;
    most.turnPerMetre = std::max(most.turnPerMetre, Angle::radians(turn));
  }
  return most;
}

TEST(BendToGoal, endsOnTheGoalWithinTheLimits) {
  const std::vector<FloorTransform> way = straightWay();
  for (const Vec2& off : {Vec2(0.08, 0.0), Vec2(-0.08, 0.0), Vec2(0.0, 0.08), Vec2(0.05, -0.07)}) {
    const auto bent = bendToGoal(way, {Vec2(8.0, 6.0) + off, {}}, openRoom());
    ASSERT_TRUE(bent.has_value());
    EXPECT_LT((bent->placements.back().translation - Vec2(8.0, 6.0) - off).norm(), 0.001);
    const ArrivalWarp most = measured(bent->placements);
    EXPECT_LE(most.stretch, 0.05 + 1e-9);
    EXPECT_LE(most.turnPerMetre.degrees(), 5.0 + 1e-6);
    EXPECT_NEAR(most.stretch, bent->warp.stretch, 1e-3);
    EXPECT_NEAR(most.turnPerMetre.degrees(), bent->warp.turnPerMetre.degrees(), 0.05);
  }
}

TEST(BendToGoal, facesTheGoalsHeadingToo) {
  const auto bent = bendToGoal(straightWay(), {{8.03, 5.85}, Angle::degrees(97)}, openRoom());
  ASSERT_TRUE(bent.has_value());
  EXPECT_LT((bent->placements.back().translation - Vec2(8.03, 5.85)).norm(), 0.001);
  EXPECT_NEAR(bent->placements.back().heading.angle().degrees(), 97.0, 0.05);
}

TEST(BendToGoal, leavesTheBeginningAlone) {
  const std::vector<FloorTransform> way = straightWay();
  const auto bent = bendToGoal(way, {{8.05, 6.05}, {}}, openRoom());
  ASSERT_TRUE(bent.has_value());
  EXPECT_EQ(bent->warp.metres, 3.0);
  for (std::size_t f = 0; f <= 74; ++f) {
    EXPECT_LT((bent->placements[f].translation - way[f].translation).norm(), 1e-12) << f;
  }
}

TEST(BendToGoal, leavesAnExactWayAsItIs) {
  const auto bent = bendToGoal(straightWay(), {{8.0005, 6.0}, {}}, openRoom());
  ASSERT_TRUE(bent.has_value());
  EXPECT_EQ(bent->warp.metres, 0.0);
}

TEST(BendToGoal, refusesWhatTakesMoreThanTheLimits) {
  EXPECT_FALSE(bendToGoal(straightWay(), {{8.5, 6.0}, {}}, openRoom()).has_value());
  EXPECT_FALSE(bendToGoal(straightWay(), {{8.0, 6.0}, Angle::degrees(150)}, openRoom()).has_value());
}

TEST(BendToGoal, refusesAWayIntoAWall) {
  Scene scene;
  scene.obstacles = {{{8.0, 6.95}, {8.0, 1.0}}};  // Its grown edge lies 5 cm beside the way.
  EXPECT_FALSE(bendToGoal(straightWay(), {{8.0, 6.08}, {}}, FloorPlan(scene, 0.4)).has_value());
  EXPECT_TRUE(bendToGoal(straightWay(), {{8.0, 6.03}, {}}, FloorPlan(scene, 0.4)).has_value());
}

TEST(MoveRoots, keepsHeightsAndTilts) {
  Clip walk;
  walk.framesPerSecond = 30.0;
  walk.jointCount = 1;
  const Quat tilt = axisRotation(Axis::kX, Angle::degrees(20));
  const std::vector<Quat> rotations = {Heading::fromAngle(Angle::degrees(90)).rotation() * tilt};
  walk.append({Vec3(2, 0.9, 6), rotations});
  const std::vector<FloorTransform> from = {{{2, 6}, Heading::fromAngle(Angle::degrees(90))}};
  const std::vector<FloorTransform> to = {{{3, 5}, Heading::fromAngle(Angle::degrees(60))}};
  moveRoots(from, to, walk);
  EXPECT_TRUE(walk.rootPositions[0].isApprox(Vec3(3, 0.9, 5), 1e-12));
  const HeadingAndTilt after = separateHeading(walk.rotationsOf(0)[0]);
  EXPECT_NEAR(after.heading.angle().degrees(), 60.0, 1e-9);
  EXPECT_LT(angleBetween(after.tilt, tilt).degrees(), 1e-5);
}

}  // namespace
}  // namespace stridegraph
