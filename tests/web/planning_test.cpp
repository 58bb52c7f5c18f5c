#include "state/planning.h"

#include <gtest/gtest.h>

#include "state/playback.h"
#include "walk/test_library.h"

namespace stridegraph {
namespace {

/// An open room of 12 m by 12 m to be crossed by a body of two joints; each look at the clock takes 0.1 ms.
class PlanningTest : public ::testing::Test {
 protected:
  PlanningTest() {
    const auto library = std::make_shared<const MotionLibrary>(stridegraph::testing::threeArcs());
    state.library = library;
    state.planner = std::make_unique<const WalkPlanner>(library);
    state.settings.goalRadiusMetres = 0.4;
    state.scene.start = {{2, 6}, Angle::degrees(90)};
    state.scene.goal = {{9, 6}, {}};
  }

  bool plansNow() {
    return planWhenDue(state, [this] { return milliseconds += 0.1; });
  }

  void changeGoal(const Vec2& goal) {
    state.scene.goal.position = goal;
    wantPlan(state);
  }

  Vec2 shownRoot() const { return onFloor(shownPose(state)->rootPosition); }

  AppState state;
  double milliseconds = 0.0;
};

TEST_F(PlanningTest, plansOnlyWhenSomethingChanged) {
  EXPECT_FALSE(plansNow());
  wantPlan(state);
  EXPECT_TRUE(plansNow());
  EXPECT_TRUE(state.hasWalk());
  EXPECT_FALSE(plansNow());
  EXPECT_EQ(state.replanning.generation, 1u);
}

TEST_F(PlanningTest, plansWithEveryFrameOfADragWhilePlansAreQuick) {
  wantPlan(state);
  ASSERT_TRUE(plansNow());
  state.drag = Drag{};
  for (int frame = 0; frame < 5; ++frame) {
    state.drag->preview = state.scene;
    state.nowSeconds += 0.1;
    wantPlan(state);
    EXPECT_TRUE(plansNow()) << frame;
  }
}

TEST_F(PlanningTest, looksLongerForABetterWalkWhereNothingIsDragged) {
  state.scene.obstacles = {{{6, 5}, {0.4, 4}}};
  state.drag = Drag{};
  state.drag->preview = state.scene;
  wantPlan(state);
  ASSERT_TRUE(plansNow());
  ASSERT_TRUE(state.hasWalk());
  const PlanReport dragged = state.plan->report;
  state.drag.reset();
  wantPlan(state);
  ASSERT_TRUE(plansNow());
  EXPECT_GT(state.plan->report.expansions, dragged.expansions);
  EXPECT_LE(state.plan->report.motionLengthMetres, dragged.motionLengthMetres + 0.1);
}

TEST_F(PlanningTest, leavesHalfOfTheTimeToTheViewWherePlansAreSlow) {
  wantPlan(state);
  ASSERT_TRUE(plansNow());
  state.drag = Drag{};
  state.drag->preview = state.scene;
  state.replanning.lastMilliseconds = 80.0;
  state.nowSeconds = state.replanning.plannedAtSeconds + 0.1;
  wantPlan(state);
  EXPECT_FALSE(plansNow());
  state.nowSeconds += 0.07;
  EXPECT_TRUE(plansNow()) << "twice as long as the plan took";
}

TEST_F(PlanningTest, goesOnFromThePresentPoseAndKeepsTheTime) {
  wantPlan(state);
  ASSERT_TRUE(plansNow());
  ASSERT_TRUE(state.hasWalk());
  state.playback.seconds = 1.0;
  const Vec2 before = shownRoot();
  changeGoal({8, 9});
  ASSERT_TRUE(plansNow());
  ASSERT_TRUE(state.hasWalk()) << statusSentence(state);
  EXPECT_TRUE(state.replanning.wentOn);
  EXPECT_EQ(state.playback.seconds, 1.0);
  EXPECT_LT((shownRoot() - before).norm(), 1e-9);
}

TEST_F(PlanningTest, beginsAnewAtTheStart) {
  wantPlan(state);
  ASSERT_TRUE(plansNow());
  state.playback.seconds = 1.0;
  changeGoal({8, 9});
  ASSERT_TRUE(plansNow());
  ASSERT_TRUE(state.replanning.wentOn);
  state.playback.seconds = 0.0;
  EXPECT_TRUE(plansNow()) << "a bent walk is planned for its room when it begins again";
  EXPECT_FALSE(state.replanning.wentOn);
  EXPECT_FALSE(plansNow());
}

TEST_F(PlanningTest, beginsAnewWhereAStartIsMoved) {
  wantPlan(state);
  ASSERT_TRUE(plansNow());
  state.playback.seconds = 1.0;
  state.scene.start.position = {2, 5};
  wantPlan(state);
  ASSERT_TRUE(plansNow());
  EXPECT_FALSE(state.replanning.wentOn);
  EXPECT_LT((onFloor(state.plan->walk.rootPositions[0]) - Vec2(2, 5)).norm(), 0.01);
}

TEST_F(PlanningTest, keepsTheWalkAndSaysWhyWhileADragLeavesNoWay) {
  wantPlan(state);
  ASSERT_TRUE(plansNow());
  state.playback.seconds = 1.0;
  const Vec2 before = shownRoot();
  const std::string arrives = statusSentence(state);
  state.drag = Drag{};
  state.drag->preview = state.scene;
  state.drag->preview.obstacles = {{{9, 6}, {2, 2}}};
  state.nowSeconds += 1.0;
  wantPlan(state);
  ASSERT_TRUE(plansNow());
  EXPECT_TRUE(state.troubleOnWay);
  EXPECT_NE(statusSentence(state), arrives);
  EXPECT_TRUE(state.hasWalk());
  EXPECT_LT((shownRoot() - before).norm(), 1e-9);
  state.scene = state.drag->preview;
  state.drag.reset();
  wantPlan(state);
  ASSERT_TRUE(plansNow());
  EXPECT_EQ(state.plan->report.status, PlanStatus::kGoalBlocked);
  EXPECT_FALSE(state.troubleOnWay);
  state.scene.obstacles.clear();
  wantPlan(state);
  ASSERT_TRUE(plansNow());
  EXPECT_EQ(statusSentence(state), arrives);
  EXPECT_EQ(state.playback.seconds, 1.0);
}

}  // namespace
}  // namespace stridegraph
