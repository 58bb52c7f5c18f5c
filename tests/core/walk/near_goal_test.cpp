// Starts and goals near to each other, with the clips that the page opens with.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "math/random.h"
#include "scene/scene_json.h"
#include "walk/near_goal.h"
#include "walk/search_trouble.h"
#include "walk/test_gait_library.h"
#include "walk/test_library.h"

namespace stridegraph {
namespace {

Scene caseOf(const std::string& name) {
  std::ifstream file(STRIDEGRAPH_TEST_DATA "/cases/" + name);
  std::stringstream text;
  text << file.rdbuf();
  const Result<Scene> scene = readSceneJson(text.str(), name);
  EXPECT_TRUE(scene.has_value()) << name;
  return scene.value_or(Scene{});
}

Plan planned(const Scene& scene, const PlanOptions& options = {}) {
  Result<Plan> plan = testing::gaitPlanner().plan(scene, options);
  EXPECT_TRUE(plan.has_value()) << describe(plan.error());
  return std::move(*plan);
}

/// As far as a walk to a near goal may go.
double mostMetres(const Scene& scene) {
  return 1.3 * (scene.goal.position - scene.start.position).norm() + 0.3;
}

bool hasOnlyFiniteFigures(const std::string& text) {
  for (const char* odd : {"inf ", "nan", "-0.0 ", "-0.00 "})
    if (text.find(odd) != std::string::npos) return false;
  return true;
}

TEST(NearGoal, takesAStepOrTwoToAGoal80CmAhead) {
  const Scene scene = caseOf("goal_80_cm_ahead.json");
  const Plan plan = planned(scene);
  ASSERT_EQ(plan.report.status, PlanStatus::kArrived) << plan.report.explanation;
  EXPECT_LE(plan.report.motionLengthMetres, mostMetres(scene));
  EXPECT_LT(plan.report.arrivalErrorMetres, 0.01);
  EXPECT_TRUE(plan.report.startsStanding);
  EXPECT_TRUE(plan.report.endsStanding);
}

TEST(NearGoal, arrivesFiveCentimetresFromTheStart) {
  const Scene scene = caseOf("start_five_cm_from_goal.json");
  const Plan plan = planned(scene);
  ASSERT_EQ(plan.report.status, PlanStatus::kArrived) << plan.report.explanation;
  EXPECT_LE(plan.report.motionLengthMetres, mostMetres(scene));
  EXPECT_LT(plan.report.arrivalErrorMetres, 0.01);
}

TEST(NearGoal, saysWhoStartsTooNearToWhom) {
  const Plan plan = planned(caseOf("two_start_too_near.json"));
  ASSERT_EQ(plan.others.size(), 3U);
  for (const PlanReport* report : {&plan.report, &plan.others[2].report}) {
    EXPECT_EQ(report->status, PlanStatus::kStartBlocked);
    EXPECT_EQ(report->explanation,
              "walkers 1 and 4 start 0.50 m apart, and bodies of radius 0.40 m need 0.83 m");
    EXPECT_EQ(report->expansions, 0U);
  }
  EXPECT_EQ(plan.others[0].report.status, PlanStatus::kArrived) << plan.others[0].report.explanation;
  EXPECT_EQ(plan.others[1].report.status, PlanStatus::kArrived) << plan.others[1].report.explanation;
}

TEST(NearGoal, standsWhereTheStartIsTheGoal) {
  Scene scene;
  scene.start = {{6, 6}, Angle::degrees(30)};
  scene.goal = scene.start;
  const Plan plan = planned(scene);
  ASSERT_EQ(plan.report.status, PlanStatus::kArrived) << plan.report.explanation;
  EXPECT_GT(plan.walk.frameCount(), 4U);
  EXPECT_LT(plan.report.motionLengthMetres, 0.1);
  EXPECT_EQ(plan.report.smallSteps, 0U);
  EXPECT_EQ(plan.report.explanation, "the start is at the goal: the body stands there");
}

/// What every plan between near places promises.
void expectSound(const Scene& scene) {
  const Plan plan = planned(scene);
  const PlanReport& report = plan.report;
  EXPECT_TRUE(hasOnlyFiniteFigures(report.explanation)) << report.explanation;
  ASSERT_EQ(report.status, PlanStatus::kArrived) << report.explanation;
  EXPECT_LT(report.arrivalErrorMetres, 0.02);
  if (report.arrivalHeadingError) {
    EXPECT_LT(report.arrivalHeadingError->degrees(), 3.0);
  }
  EXPECT_GE(report.clearanceMetres, -FloorPlan::kTouchToleranceMetres);
  EXPECT_LT(report.jointSpeed.ratio, 2.0);
  EXPECT_LT(report.jointAcceleration.ratio, 2.0);
  EXPECT_LT(report.footSkateCmPerSecond, 15.0);
  if (report.smallSteps > 0) {
    EXPECT_LE(report.motionLengthMetres, 1.3 * (scene.goal.position - scene.start.position).norm() + 0.6);
  }
}

TEST(NearGoal, isReachedFromEverywhereWithinOneAndAHalfMetres) {
  Random random(11);
  for (int i = 0; i < 60; ++i) {
    const Heading way = Heading::fromAngle(Angle::degrees(360.0 * random.uniform()));
    Scene scene;
    scene.seed = static_cast<std::uint64_t>(i);
    scene.start.position = {6, 6};
    scene.goal.position = scene.start.position + 1.5 * random.uniform() * way.direction();
    if (i % 4 != 0) scene.start.heading = Angle::degrees(360.0 * random.uniform() - 180.0);
    if (i % 3 == 0) scene.goal.heading = Angle::degrees(360.0 * random.uniform() - 180.0);
    SCOPED_TRACE(i);
    expectSound(scene);
  }
}

TEST(NearGoal, isReachedInARoomThatIsHardlyLarger) {
  Random random(12);
  for (int i = 0; i < 20; ++i) {
    Scene scene;
    scene.widthMetres = 1.6;
    scene.depthMetres = 2.2;
    scene.start = {{0.8, 0.6}, Angle::degrees(360.0 * random.uniform() - 180.0)};
    scene.goal.position = {0.8, 0.6 + random.uniform()};
    SCOPED_TRACE(i);
    expectSound(scene);
  }
}

TEST(NearGoal, cannotBeReplannedOnceTheWalkIsUnderWay) {
  const Scene scene = caseOf("goal_80_cm_ahead.json");
  const Plan plan = planned(scene);
  Scene edited = scene;
  edited.goal.position.x() += 0.3;
  const Result<Plan> again = testing::gaitPlanner().replan(plan, 10, edited);
  ASSERT_TRUE(again.has_value());
  EXPECT_NE(again->report.explanation, "");
}

TEST(NearGoal, saysThatAWalkerWhoCannotGoStaysAtTheGoalOfAnother) {
  Scene scene;
  scene.start = {{2, 2}, {}};
  scene.goal = {{9, 9}, {}};
  // Walkers 2 and 3 start within each other, and walker 2 where the first one is to go.
  scene.walkers = {{{{9, 8.7}, {}}, {{2, 9}, {}}}, {{{9, 8.2}, {}}, {{9, 2}, {}}}};
  const Plan plan = planned(scene);
  EXPECT_EQ(plan.others[0].report.status, PlanStatus::kStartBlocked);
  EXPECT_EQ(plan.others[1].report.status, PlanStatus::kStartBlocked);
  EXPECT_EQ(plan.report.status, PlanStatus::kGoalBlocked);
  EXPECT_EQ(plan.report.explanation, "walker 2 stays at the goal");
}

TEST(NearGoal, turnsOnTheSpotWhereOnlyTheHeadingDiffers) {
  for (const double degrees : {20.0, 90.0, -150.0, 180.0}) {
    Scene scene;
    scene.start = {{6, 6}, Angle::degrees(0)};
    scene.goal = {{6, 6}, Angle::degrees(degrees)};
    const Plan plan = planned(scene);
    ASSERT_EQ(plan.report.status, PlanStatus::kArrived) << plan.report.explanation;
    EXPECT_LT(plan.report.arrivalHeadingError->degrees(), 3.0);
    EXPECT_LT(plan.report.motionLengthMetres, 0.5);
  }
}

TEST(NearGoal, saysThatAMovingBlockIsAtTheStart) {
  Scene scene = caseOf("goal_80_cm_ahead.json");
  scene.moving = {{{1, 1}, TrackRepeat::kOnce, {{0.0, {3.4, 3.0}}, {2.0, {0.5, 0.5}}}}};
  const Plan plan = planned(scene);
  EXPECT_EQ(plan.report.status, PlanStatus::kStartBlocked);
  EXPECT_NE(plan.report.explanation.find("moving block 1 is at the start of walker 1"), std::string::npos)
      << plan.report.explanation;
}

TEST(NearGoal, hasOnlyFiniteFiguresInSentencesForLibrariesThatNeverStand) {
  const WalkPlanner planner(std::make_shared<const MotionLibrary>(testing::threeArcs()));
  for (const double metres : {0.0, 0.05, 0.3, 0.8}) {
    for (const double side : {2.0, 12.0}) {
      Scene scene;
      scene.widthMetres = side;
      scene.depthMetres = side;
      scene.start = {{0.5, 0.5}, Angle::degrees(0)};
      scene.goal = {{0.5 + metres, 0.5}, Angle::degrees(90)};
      const Result<Plan> plan = planner.plan(scene);
      ASSERT_TRUE(plan.has_value());
      EXPECT_TRUE(hasOnlyFiniteFigures(plan->report.explanation)) << plan->report.explanation;
      if (plan->report.status != PlanStatus::kArrived) {
        EXPECT_NE(plan->report.explanation, "");
      }
    }
  }
}

TEST(SearchTrouble, tellsNothingOfPlacesWhereNoneWasReached) {
  const FloorPlan floor(Scene{}, 0.4);
  SearchTrouble trouble;
  trouble.begun = true;
  trouble.tooLate = 1;
  const std::string text = explainNoMotion(trouble, floor, {});
  EXPECT_EQ(
      text,
      "no walk that these clips can make leads through: no way from the start comes to a place where it "
      "could go on; more clips, tighter turns or a mirrored library would help");
}

TEST(ShortestWalk, isThatOfTheClipsFromAStandToAStand) {
  const MotionLibrary stops = testing::threeArcsAndAStop();
  EXPECT_FALSE(shortestWalkMetres(SearchTables(stops)).has_value()) << "it cannot begin standing";
  const std::optional<double> metres = shortestWalkMetres(SearchTables(testing::gaitPlanner().library()));
  ASSERT_TRUE(metres.has_value());
  EXPECT_GT(*metres, 0.2);
  EXPECT_LT(*metres, 2.0);
}

}  // namespace
}  // namespace stridegraph
