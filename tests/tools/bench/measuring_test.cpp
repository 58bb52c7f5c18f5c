#include "bench/measuring.h"

#include <gtest/gtest.h>

#include "walk/test_library.h"

namespace stridegraph::bench {
namespace {

/// A room of 12 by 12 m to be crossed, with a wall from one side that leaves a gap of 2 m.
BenchRoom roomWithGap() {
  BenchRoom room{kMapsSet, "gap", {}, 8.0};
  room.scene.start = {{2, 6}, Angle::degrees(90)};
  room.scene.goal = {{9, 6}, {}};
  room.scene.obstacles = {{{6, 5}, {0.4, 10}}};
  return room;
}

/// A clock that is a millisecond later whenever it is asked.
MeasureParams countingParams() {
  MeasureParams params;
  params.clock = [now = std::make_shared<double>(0.0)] { return *now += 1.0; };
  return params;
}

WalkPlanner planner() {
  return WalkPlanner(std::make_shared<const MotionLibrary>(testing::threeArcs()));
}

TEST(MeasureWalk, takesItsFiguresFromThePlan) {
  const MeasureParams params = countingParams();
  const BenchRun run = measureWalk(planner(), roomWithGap(), kGuidedMethod, 3, params);
  PlanOptions options;
  options.seed = 3;
  const Plan plan = *planner().plan(roomWithGap().scene, options);
  EXPECT_TRUE(isSound(run)) << run.status;
  EXPECT_EQ(run.place, "native");
  EXPECT_EQ(run.set, "maps");
  EXPECT_EQ(run.room, "gap");
  EXPECT_EQ(run.method, "guided");
  EXPECT_EQ(run.seed, 3U);
  EXPECT_EQ(run.lengthMetres, plan.report.motionLengthMetres);
  EXPECT_EQ(run.transitions, static_cast<double>(plan.report.transitions));
  EXPECT_EQ(run.expansions, static_cast<double>(plan.report.expansions));
  EXPECT_EQ(run.clearanceMetres, plan.report.clearanceMetres);
  EXPECT_GT(run.blendedShare, 0.0);
  EXPECT_LT(run.blendedShare, 1.0);
  EXPECT_GT(run.totalMilliseconds, 0.0);
  EXPECT_EQ(run.edges.size(), 16U);
}

TEST(MeasureWalk, stopsTheThesisInItsTime) {
  MeasureParams params = countingParams();
  params.thesisBudgetMilliseconds = 0.5;
  EXPECT_EQ(measureWalk(planner(), roomWithGap(), walkMethods()[2], 1, params).status, "budget_spent");
  EXPECT_EQ(measureWalk(planner(), roomWithGap(), walkMethods()[3], 1, params).status, "budget_spent");
  EXPECT_EQ(measureWalk(planner(), roomWithGap(), kGuidedMethod, 1, params).status, "arrived");
}

TEST(MeasureWalk, looksForBetterWalksWhereTheMethodImproves) {
  const MeasureParams params = countingParams();
  const BenchRun first = measureWalk(planner(), roomWithGap(), kGuidedMethod, 1, params);
  const BenchRun improved = measureWalk(planner(), roomWithGap(), walkMethods()[1], 1, params);
  EXPECT_EQ(improved.method, "guided-improved");
  EXPECT_TRUE(isSound(improved)) << improved.status;
  EXPECT_GT(improved.expansions, first.expansions);
  EXPECT_GT(improved.motionMilliseconds, first.motionMilliseconds);
}

TEST(MeasureWalk, knowsEverySearch) {
  std::vector<std::string> names;
  for (const WalkMethod& method : walkMethods()) names.push_back(method.name);
  EXPECT_EQ(names, (std::vector<std::string>{"guided", "guided-improved", "thesis", "thesis-checked"}));
}

TEST(MeasureWalk, saysWhatIsWrongWithARoom) {
  BenchRoom room = roomWithGap();
  room.scene.widthMetres = -1.0;
  const BenchRun run = measureWalk(planner(), room, kGuidedMethod, 1, countingParams());
  EXPECT_EQ(run.status, "scene_value");
  EXPECT_NE(run.explanation, "");
}

TEST(MeasurePath, findsFreePathsByEveryMethod) {
  const BenchRoom room = roomWithGap();
  std::vector<std::string> names;
  for (const PathMethod& method : pathMethods()) {
    names.push_back(method.name);
    const BenchRun run = measurePath(method, room, 1, countingParams());
    EXPECT_TRUE(isSound(run)) << method.name << ": " << run.status;
    EXPECT_EQ(run.method, method.name);
    EXPECT_EQ(run.library, "");
    EXPECT_GT(run.lengthMetres, 8.0) << "of 7 m in a straight line";
    EXPECT_GT(run.totalMilliseconds, run.pathMilliseconds);
    EXPECT_NEAR(run.clearanceMetres, 0.0, 0.3);
  }
  EXPECT_EQ(names[0], "exact");
  EXPECT_EQ(names[1], "prm");
  EXPECT_EQ(names[2], "rrt-connect");
}

TEST(MeasurePath, refusesASealedGoalByEveryMethod) {
  BenchRoom room = roomWithGap();
  room.scene.obstacles = {{{6, 6}, {0.4, 12}}};
  room.shortestMetres.reset();
  for (const PathMethod& method : pathMethods())
    EXPECT_TRUE(isSound(measurePath(method, room, 1, countingParams()))) << method.name;
}

TEST(MeasurePath, callsAPathThroughAWallUnsound) {
  const PathMethod straight{
      "straight", false, [](const FloorPlan&, const Placement& start, const Placement& goal, std::uint64_t) {
        return PathAnswer{"found", (goal.position - start.position).norm(), {start.position, goal.position}};
      }};
  const BenchRun run = measurePath(straight, roomWithGap(), 1, countingParams());
  EXPECT_LT(run.clearanceMetres, 0.0);
  EXPECT_FALSE(isSound(run));
}

TEST(Measure, countsTheQuickestOfItsRepeats) {
  MeasureParams params = countingParams();
  const std::vector<double> starts = {0.0, 0.0, 9.0, 100.0, 100.0, 103.0, 200.0, 200.0, 205.0};
  params.clock = [starts, next = std::make_shared<std::size_t>(0)] { return starts[(*next)++]; };
  params.repeats = 3;
  const BenchRun run = measurePath(pathMethods().front(), roomWithGap(), 1, params);
  EXPECT_DOUBLE_EQ(run.totalMilliseconds, 3.0);
}

}  // namespace
}  // namespace stridegraph::bench
