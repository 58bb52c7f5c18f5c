// Walkers and obstacles that move, and wishes, in rooms with the shipped library's like.
#include <gtest/gtest.h>

#include <cmath>

#include "scene/track.h"
#include "walk/plan.h"
#include "walk/test_gait_library.h"

namespace stridegraph {
namespace {

constexpr double kRadius = 0.4;

Scene hall() {
  Scene scene;
  scene.widthMetres = 16.0;
  scene.depthMetres = 12.0;
  scene.start = {{2.0, 6.0}, Angle::degrees(90.0)};
  scene.goal = {{14.0, 6.0}, std::nullopt};
  return scene;
}

Plan planned(const Scene& scene, const PlanOptions& options = {}) {
  Result<Plan> plan = testing::gaitPlanner().plan(scene, options);
  EXPECT_TRUE(plan.has_value()) << describe(plan.error());
  return std::move(*plan);
}

Vec2 placeAt(const Plan& plan, std::size_t frame) {
  const Vec3& root = plan.walk.rootPositions[std::min(frame, plan.walk.frameCount() - 1)];
  return {root.x(), root.z()};
}

/// Of the disc's rim from a moving rectangle, over the frames of the walk.
double leastClearance(const Plan& plan, const MovingObstacle& obstacle) {
  double least = 1e9;
  for (std::size_t f = 0; f < plan.walk.frameCount(); ++f) {
    const Rectangle box = rectangleAt(obstacle, static_cast<double>(f) / plan.walk.framesPerSecond);
    const Vec2 apart = ((placeAt(plan, f) - box.centre).cwiseAbs() - 0.5 * box.size).cwiseMax(0.0);
    least = std::min(least, apart.norm() - kRadius);
  }
  return least;
}

TEST(Crowd, passesAnObstacleThatCrossesTheOnlyGapWithoutTouchingIt) {
  Scene scene = hall();
  scene.obstacles = {{{8.0, 2.5}, {0.6, 5.0}}, {{8.0, 9.5}, {0.6, 5.0}}};
  scene.moving = {
      {{1.2, 1.2}, TrackRepeat::kPingPong, {{0.0, {8.0, 6.0}}, {5.0, {8.0, 6.0}}, {8.0, {8.0, 10.0}}}}};
  const Plan plan = planned(scene);
  ASSERT_EQ(plan.report.status, PlanStatus::kArrived) << plan.report.explanation;
  EXPECT_GT(leastClearance(plan, scene.moving[0]), 0.0);
  EXPECT_GE(plan.report.clearanceMetres, -1e-6);
  ASSERT_TRUE(plan.report.movingClearanceMetres);
  EXPECT_NEAR(*plan.report.movingClearanceMetres, leastClearance(plan, scene.moving[0]), 1e-6);
}

/// A box of 1 m that is at the goal of hall() until a time, and gone three seconds later.
MovingObstacle atTheGoalUntil(double seconds) {
  return {{1.0, 1.0},
          TrackRepeat::kOnce,
          {{0.0, {14.0, 6.0}}, {seconds, {14.0, 6.0}}, {seconds + 3.0, {14.0, 1.0}}}};
}

TEST(Crowd, arrivesWhereAnObstacleStandsAtTheGoalOnlyAfterItHasGone) {
  Scene scene = hall();
  scene.moving = {atTheGoalUntil(15.0)};
  const Plan plan = planned(scene);
  ASSERT_EQ(plan.report.status, PlanStatus::kArrived) << plan.report.explanation;
  EXPECT_GT(plan.report.durationSeconds, 15.0);
  EXPECT_GT(leastClearance(plan, scene.moving[0]), 0.0);
  EXPECT_FALSE(plan.report.goalFreeUntilSeconds);
}

TEST(Crowd, tellsUntilWhenTheGoalIsFreeWhereAnObstacleComesByLater) {
  Scene scene = hall();
  // Its edge reaches the rim of who stands at (14, 6) when its middle is at z = 5.1.
  scene.moving = {
      {{1.0, 1.0}, TrackRepeat::kOnce, {{0.0, {14.0, 1.0}}, {30.0, {14.0, 1.0}}, {40.0, {14.0, 11.0}}}}};
  const Plan plan = planned(scene);
  ASSERT_EQ(plan.report.status, PlanStatus::kArrived);
  ASSERT_TRUE(plan.report.goalFreeUntilSeconds);
  EXPECT_NEAR(*plan.report.goalFreeUntilSeconds, 34.1, 0.1);
  EXPECT_NE(plan.report.explanation.find("until 34."), std::string::npos) << plan.report.explanation;
  EXPECT_NE(toJson(plan).find("\"goal_free_until_s\": 34."), std::string::npos);
  // It changes nothing else.
  scene.moving.clear();
  EXPECT_EQ(toJson(planned(scene)).find("goal_free_until_s"), std::string::npos);
}

TEST(Crowd, saysAtOnceThatAnObstacleStaysAtTheGoal) {
  Scene scene = hall();
  scene.moving = {{{1.0, 1.0}, TrackRepeat::kOnce, {{0.0, {14.0, 11.0}}, {3.0, {14.0, 6.0}}}}};
  const Plan plan = planned(scene);
  EXPECT_EQ(plan.report.status, PlanStatus::kGoalBlocked);
  EXPECT_NE(plan.report.explanation.find("moving block 1 is at the goal"), std::string::npos);
  EXPECT_EQ(plan.report.expansions, 0U);
}

/// The least distance between two walkers over all frames; who has arrived stands.
double leastApart(const Plan& a, const Plan& b) {
  double least = 1e9;
  for (std::size_t f = 0; f < std::max(a.walk.frameCount(), b.walk.frameCount()); ++f)
    least = std::min(least, (placeAt(a, f) - placeAt(b, f)).norm());
  return least;
}

void expectBothArriveApart(const Plan& plan) {
  ASSERT_EQ(plan.report.status, PlanStatus::kArrived) << plan.report.explanation;
  ASSERT_EQ(plan.others[0].report.status, PlanStatus::kArrived) << plan.others[0].report.explanation;
  EXPECT_GT(leastApart(plan, plan.others[0]), 2.0 * kRadius);
}

TEST(Crowd, goesAroundWhoHasArrived) {
  Scene scene = hall();
  scene.walkers = {{{{8.0, 3.0}, Angle::degrees(0.0)}, {{8.0, 6.0}, std::nullopt}}};
  expectBothArriveApart(planned(scene));
}

TEST(Crowd, waitsForWhoComesByWhereThereIsNoWayAround) {
  Scene scene = hall();
  // The goal of the second walker is in a passage that is 1.4 m wide, which the first walker needs.
  scene.obstacles = {{{8.0, 2.65}, {6.0, 5.3}}, {{8.0, 9.35}, {6.0, 5.3}}};
  scene.start.position = {4.0, 6.0};
  scene.walkers = {{{{2.0, 2.0}, Angle::degrees(0.0)}, {{6.0, 6.0}, std::nullopt}}};
  expectBothArriveApart(planned(scene));
}

TEST(Crowd, saysThatAnotherWalkerStaysAtTheGoal) {
  Scene scene = hall();
  scene.walkers = {{{{8.0, 3.0}, Angle::degrees(0.0)}, scene.goal}};
  const Plan plan = planned(scene);
  EXPECT_EQ(plan.report.status, PlanStatus::kArrived);
  EXPECT_EQ(plan.others[0].report.status, PlanStatus::kGoalBlocked);
  EXPECT_EQ(
      plan.others[0].report.explanation,
      "the goals of walkers 1 and 2 are 0.00 m apart, and bodies of radius 0.40 m need 0.83 m: walker 1 "
      "stays there");
}

TEST(Crowd, crossesASquareWithoutAnyoneTouchingAnother) {
  Scene scene = hall();
  scene.depthMetres = 16.0;
  constexpr int kWalkers = 6;
  const Vec2 middle(8.0, 8.0);
  std::vector<Walker> walkers;
  for (int i = 0; i < kWalkers; ++i) {
    const Heading outward = Heading::fromAngle(Angle::degrees(360.0 / kWalkers * i));
    const Vec2 arm = 6.0 * outward.direction();
    walkers.push_back(
        {{middle + arm, Angle::degrees(360.0 / kWalkers * i + 180.0)}, {middle - arm, std::nullopt}});
  }
  scene.start = walkers.front().start;
  scene.goal = walkers.front().goal;
  scene.walkers.assign(walkers.begin() + 1, walkers.end());
  const Plan plan = planned(scene);
  ASSERT_EQ(plan.others.size(), kWalkers - 1U);
  std::vector<const Plan*> all = {&plan};
  for (const Plan& other : plan.others) all.push_back(&other);
  std::size_t frames = 0;
  for (const Plan* one : all) {
    ASSERT_EQ(one->report.status, PlanStatus::kArrived) << one->report.explanation;
    frames = std::max(frames, one->walk.frameCount());
  }
  for (std::size_t f = 0; f < frames; ++f) {
    for (std::size_t a = 0; a < all.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        ASSERT_GT((placeAt(*all[a], f) - placeAt(*all[b], f)).norm(), 2.0 * kRadius)
            << a << " " << b << " at " << f;
  }
}

TEST(Crowd, goesAroundAnAreaToAvoidWhereTheDetourIsShort) {
  Scene scene = hall();
  const Rectangle area{{8.0, 5.5}, {3.0, 2.0}};
  const auto metresInside = [&](const Plan& plan) {
    double metres = 0.0;
    for (std::size_t f = 1; f < plan.walk.frameCount(); ++f) {
      const Vec2 apart = (placeAt(plan, f) - area.centre).cwiseAbs() - 0.5 * area.size;
      if (apart.maxCoeff() < 0.0) metres += (placeAt(plan, f) - placeAt(plan, f - 1)).norm();
    }
    return metres;
  };
  EXPECT_GT(metresInside(planned(scene)), 2.0);
  scene.constraints.areas = {{area, AreaKind::kAvoid}};
  const Plan around = planned(scene);
  EXPECT_LT(metresInside(around), 0.3);
  // The path that is shown heeds the area, too.
  EXPECT_EQ(around.path.front(), scene.start.position);
  EXPECT_EQ(around.path.back(), scene.goal.position);
  for (std::size_t i = 1; i < around.path.size(); ++i) {
    EXPECT_LT((around.path[i] - around.path[i - 1]).norm(), 0.5);
    EXPECT_GT(((around.path[i] - area.centre).cwiseAbs() - 0.5 * area.size).maxCoeff(), -0.15) << i;
  }
}

TEST(Crowd, walksWhereItMayNotRunAndTellsHowWellItKeepsToIt) {
  Scene scene = hall();
  scene.constraints.gait = Gait::kWalk;
  const Plan walk = planned(scene);
  ASSERT_TRUE(walk.report.constraintsKept);
  EXPECT_EQ(*walk.report.constraintsKept, 1.0);
  scene.constraints.gait = Gait::kRun;
  const Plan run = planned(scene);
  ASSERT_TRUE(run.report.constraintsKept);
  EXPECT_GT(*run.report.constraintsKept, 0.3);
  EXPECT_LT(run.report.durationSeconds, walk.report.durationSeconds);
}

/// 34 m straight on.
Scene longHall() {
  Scene scene = hall();
  scene.widthMetres = 40.0;
  scene.start.position = {3.0, 6.0};
  scene.goal.position = {37.0, 6.0};
  return scene;
}

TEST(Crowd, runsALongHallFromAStandToAStand) {
  Scene scene = longHall();
  scene.constraints.gait = Gait::kRun;
  const Plan run = planned(scene);
  ASSERT_EQ(run.report.status, PlanStatus::kArrived) << run.report.explanation;
  EXPECT_TRUE(run.report.startsStanding);
  EXPECT_TRUE(run.report.endsStanding);
  EXPECT_LT(run.report.motionLengthMetres, 35.0);
  // Getting going and stopping take some five seconds, in which these clips cannot run.
  EXPECT_GT(*run.report.constraintsKept, 0.68);
  EXPECT_LT(run.report.expansions, 4000U);
  PlanOptions flyingStart;
  flyingStart.standing = false;
  const Plan flying = planned(scene, flyingStart);
  EXPECT_GT(*flying.report.constraintsKept, 0.9);
}

TEST(Crowd, hurriesFromAStandToAStandToBeThereInTime) {
  Scene scene = longHall();
  for (const double seconds : {16.5, 18.0, 20.0}) {
    scene.constraints.latestArrivalSeconds = seconds;
    const Plan plan = planned(scene);
    ASSERT_EQ(plan.report.status, PlanStatus::kArrived) << plan.report.explanation;
    EXPECT_LE(plan.report.durationSeconds, seconds);
    EXPECT_TRUE(plan.report.startsStanding && plan.report.endsStanding) << seconds;
    EXPECT_LT(plan.report.expansions, 4000U);
  }
}

TEST(Crowd, saysAtOnceHowLongItWouldTakeWhereTheTimeIsTooShort) {
  Scene scene = longHall();
  scene.constraints.latestArrivalSeconds = 9.0;
  const Plan plan = planned(scene);
  EXPECT_EQ(plan.report.status, PlanStatus::kNoMotion);
  EXPECT_LT(plan.report.expansions, 100U);
  EXPECT_NE(plan.report.explanation.find("would take about 11."), std::string::npos)
      << plan.report.explanation;
}

TEST(Crowd, plansTheSameWalkWhateverWasAskedForBefore) {
  Scene scene = longHall();
  scene.constraints.gait = Gait::kRun;
  const Plan before = planned(scene);
  Scene other = longHall();
  for (const double speed : {0.9, 1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7}) {
    other.constraints.minSpeedMetresPerSecond = speed;
    EXPECT_EQ(planned(other).report.status, PlanStatus::kArrived);
  }
  EXPECT_EQ(planned(scene).report.edges, before.report.edges);
}

TEST(Crowd, isThereInTimeOrSaysThatItCannotBe) {
  Scene scene = hall();
  scene.constraints.gait = Gait::kWalk;
  const double usual = planned(scene).report.durationSeconds;
  scene.constraints.latestArrivalSeconds = usual;
  const Plan inTime = planned(scene);
  ASSERT_EQ(inTime.report.status, PlanStatus::kArrived) << inTime.report.explanation;
  EXPECT_LE(inTime.report.durationSeconds, usual + 1e-9);
  scene.constraints.latestArrivalSeconds = 2.0;
  const Plan tooLate = planned(scene);
  EXPECT_EQ(tooLate.report.status, PlanStatus::kNoMotion);
  EXPECT_NE(tooLate.report.explanation.find("in the time asked for"), std::string::npos)
      << tooLate.report.explanation;
}

TEST(Crowd, saysWhatStandsInTheWayOfTheFirstStep) {
  Scene scene = hall();
  scene.obstacles = {{{2.95, 6.0}, {1.0, 1.6}},
                     {{2.0, 7.0}, {1.0, 1.0}},
                     {{2.0, 5.0}, {1.0, 1.0}},
                     {{1.05, 6.0}, {1.0, 1.6}}};
  scene.start.position = {2.0, 6.0};
  scene.radiusMetres = 0.4;
  const Plan plan = planned(scene);
  EXPECT_NE(plan.report.status, PlanStatus::kArrived);
  EXPECT_FALSE(plan.report.explanation.empty());
}

}  // namespace
}  // namespace stridegraph
