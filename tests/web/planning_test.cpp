#include "state/planning.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "state/playback.h"
#include "state/state_json.h"
#include "walk/test_gait_library.h"
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

/// The library that the page opens with, and a room with a wall to walk round; each look at the clock takes a
/// millisecond.
class BetterWalkTest : public ::testing::Test {
 protected:
  BetterWalkTest() {
    const std::shared_ptr<const WalkPlanner> shared = stridegraph::testing::sharedGaitPlanner();
    state.library = {shared, &shared->library()};
    state.planner = std::make_unique<const WalkPlanner>(state.library);
    state.scene.obstacles = {{{6, 4}, {0.5, 8}}};
    state.scene.start = {{2, 3}, Angle::degrees(90)};
    state.scene.goal = {{10, 3}, {}};
  }

  double now() { return milliseconds += 1.0; }

  bool plansNow() {
    return planWhenDue(state, [this] { return now(); });
  }

  bool improve() {
    return improveWalk(
        state, [this] { return now(); }, 0.001);
  }

  void improveAll() {
    while (state.replanning.improving) improve();
  }

  /// To a walk that is longer than it has to be.
  void planFirst() {
    wantPlan(state);
    ASSERT_TRUE(plansNow());
    ASSERT_TRUE(state.replanning.improving);
  }

  AppState state;
  double milliseconds = 0.0;
};

TEST_F(BetterWalkTest, looksForABetterWalkWhereNothingIsDragged) {
  state.drag = Drag{};
  state.drag->preview = state.scene;
  wantPlan(state);
  ASSERT_TRUE(plansNow());
  ASSERT_TRUE(state.hasWalk());
  const PlanReport dragged = state.plan->report;
  EXPECT_FALSE(state.replanning.improving);
  state.drag.reset();
  wantPlan(state);
  ASSERT_TRUE(plansNow());
  EXPECT_EQ(state.plan->report.expansions, dragged.expansions) << "the first walk is shown at once";
  ASSERT_TRUE(state.replanning.improving);
  improveAll();
  EXPECT_GT(state.plan->report.expansions, dragged.expansions);
  EXPECT_LT(state.plan->report.motionLengthMetres, dragged.motionLengthMetres);
}

TEST_F(BetterWalkTest, takesAFewMillisecondsOfAFrameForABetterWalk) {
  planFirst();
  const double before = milliseconds;
  improve();
  EXPECT_GE(milliseconds - before, 5.0);
  EXPECT_LE(milliseconds - before, 15.0) << "each look takes a millisecond, and the search looks, too";
  EXPECT_TRUE(state.replanning.improving);
  EXPECT_TRUE(nlohmann::json::parse(toJson(state))["planning"]);
  improveAll();
  EXPECT_FALSE(nlohmann::json::parse(toJson(state))["planning"]);
}

TEST_F(BetterWalkTest, beginsToPlayWhenNoBetterWalkIsLookedForAnyMore) {
  planFirst();
  state.playback.playing = true;
  EXPECT_FALSE(advance(state, 0.1));
  improveAll();
  EXPECT_TRUE(advance(state, 0.1));
}

TEST_F(BetterWalkTest, showsABetterWalkOnlyWhereNoBodyJumps) {
  planFirst();
  const std::vector<Vec3> first = state.plan->walk.rootPositions;
  state.playback.seconds = 0.8 * state.walkSeconds();
  const unsigned generation = state.replanning.generation;
  improveAll();
  ASSERT_TRUE(state.replanning.better);
  EXPECT_EQ(state.plan->walk.rootPositions, first);
  EXPECT_EQ(state.replanning.generation, generation);
  state.playback.seconds = 0.0;
  EXPECT_TRUE(improve());
  EXPECT_NE(state.plan->walk.rootPositions, first);
  EXPECT_GT(state.replanning.generation, generation);
  EXPECT_FALSE(state.replanning.better);
}

TEST_F(BetterWalkTest, looksForNoBetterWalkForASceneThatChanges) {
  planFirst();
  improve();
  state.scene.goal.position = {10, 9};
  wantPlan(state);
  EXPECT_FALSE(improve());
  ASSERT_TRUE(plansNow());
  EXPECT_FALSE(state.replanning.better);
  EXPECT_LT((state.plan->scene.goal.position - Vec2(10, 9)).norm(), 1e-9);
}

}  // namespace
}  // namespace stridegraph
