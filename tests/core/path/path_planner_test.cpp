#include "path/path_planner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "path/polyline.h"
#include "path/roadmap.h"
#include "path/shortest_path.h"
#include "path/test_rooms.h"

namespace stridegraph {
namespace {

constexpr double kRadius = 0.4;

/// What every planner promises.
class PlannerContract : public testing::TestWithParam<PlannerKind> {
 protected:
  static PathResult plan(const Scene& scene, std::uint64_t seed = 1, const PathParams& params = {}) {
    return planPath(FloorPlan(scene, kRadius), scene.start.position, scene.goal.position, GetParam(), seed,
                    params);
  }

  static void expectSound(const Scene& scene, const PathResult& result) {
    const FloorPlan floor(scene, kRadius);
    ASSERT_EQ(result.status, PathStatus::kFound);
    ASSERT_GE(result.path.size(), 2U);
    EXPECT_EQ(result.path.front(), scene.start.position);
    EXPECT_EQ(result.path.back(), scene.goal.position);
    for (std::size_t i = 1; i < result.path.size(); ++i) {
      EXPECT_TRUE(floor.isFree(result.path[i - 1], result.path[i])) << "segment " << i;
    }
    for (const auto& [from, to] : result.roadmapEdges) EXPECT_TRUE(floor.isFree(from, to));
    EXPECT_DOUBLE_EQ(result.lengthMetres, polylineLength(result.path));
    const auto shortest = shortestPath(floor, scene.start.position, scene.goal.position);
    ASSERT_TRUE(shortest);
    EXPECT_GE(result.lengthMetres, shortest->lengthMetres - 1e-5);
  }
};

TEST_P(PlannerContract, findsAFreePathAroundABlock) {
  const Scene scene = roomWithOneBlock();
  const PathResult result = plan(scene);
  expectSound(scene, result);
  EXPECT_FALSE(result.roadmapEdges.empty());
  EXPECT_LT(result.lengthMetres, 1.1 * 6.915);
}

TEST_P(PlannerContract, saysThatTheStartIsBlocked) {
  Scene scene = roomWithOneBlock();
  scene.start.position = {5.0, 5.0};
  const PathResult result = plan(scene);
  EXPECT_EQ(result.status, PathStatus::kStartBlocked);
  EXPECT_TRUE(result.path.empty());
}

TEST_P(PlannerContract, saysThatTheGoalIsBlocked) {
  Scene scene = roomWithOneBlock();
  scene.goal.position = {9.9, 5.0};
  EXPECT_EQ(plan(scene).status, PathStatus::kGoalBlocked);
}

TEST_P(PlannerContract, saysThatThereIsNoWayToASealedGoal) {
  const PathResult result = plan(roomWithSealedGoal());
  EXPECT_EQ(result.status, PathStatus::kNoPath);
  EXPECT_TRUE(result.path.empty());
  EXPECT_EQ(result.lengthMetres, 0.0);
}

TEST_P(PlannerContract, goesNowhereWhenStartEqualsGoal) {
  Scene scene = roomWithOneBlock();
  scene.goal = scene.start;
  const PathResult result = plan(scene);
  expectSound(scene, result);
  EXPECT_EQ(result.lengthMetres, 0.0);
}

TEST_P(PlannerContract, givesTheSameAnswerForTheSameSeed) {
  Random random(31);
  Scene scene = randomRoom(random, 15);
  while (!placeEnds(random, scene, kRadius) || plan(scene).status != PathStatus::kFound) {
    scene = randomRoom(random, 15);
  }
  const PathResult first = plan(scene, 7);
  const PathResult second = plan(scene, 7);
  EXPECT_EQ(first.path, second.path);
  EXPECT_EQ(first.roadmapEdges, second.roadmapEdges);
  EXPECT_NE(first.roadmapEdges, plan(scene, 8).roadmapEdges);
}

TEST_P(PlannerContract, neverMissesAWayNorInventsOneInRandomRooms) {
  Random random(32);
  int found = 0;
  int refused = 0;
  for (int room = 0; room < 150; ++room) {
    Scene scene = randomRoom(random, 45);
    if (!placeEnds(random, scene, kRadius)) continue;
    const PathResult result = plan(scene, static_cast<std::uint64_t>(room));
    const auto shortest = shortestPath(FloorPlan(scene, kRadius), scene.start.position, scene.goal.position);
    ASSERT_EQ(result.status == PathStatus::kFound, shortest.has_value()) << "room " << room;
    (shortest ? found : refused) += 1;
    if (shortest) expectSound(scene, result);
  }
  EXPECT_GT(found, 30);
  EXPECT_GT(refused, 30);
}

TEST_P(PlannerContract, fallsBackToTheExactPathWhenSamplesMissTheGap) {
  Scene scene = roomWithGap(2.0 * kRadius + 1e-4);
  scene.start.position = {3.0, 1.5};
  scene.goal.position = {9.0, 1.5};
  PathParams params;
  params.roadmapNodes = 50;
  params.growths = 1;
  params.treeSamples = 50;
  const PathResult result = plan(scene, 1, params);
  expectSound(scene, result);
  EXPECT_TRUE(result.usedShortestPath);
}

TEST_P(PlannerContract, leavesThePathAsPlannedWithoutShortcuts) {
  const Scene scene = roomWithOneBlock();
  PathParams params;
  params.shortcutRounds = 0;
  const PathResult raw = plan(scene, 1, params);
  expectSound(scene, raw);
  EXPECT_LE(plan(scene).lengthMetres, raw.lengthMetres);
}

INSTANTIATE_TEST_SUITE_P(EveryPlanner, PlannerContract,
                         testing::Values(PlannerKind::kPrm, PlannerKind::kRrtConnect),
                         [](const testing::TestParamInfo<PlannerKind>& planner) {
                           return planner.param == PlannerKind::kPrm ? "prm" : "rrtConnect";
                         });

TEST(PathPlanner, namesPlannersAndStatuses) {
  for (const PlannerKind kind : {PlannerKind::kPrm, PlannerKind::kRrtConnect}) {
    EXPECT_EQ(plannerFromName(plannerName(kind)), kind);
  }
  EXPECT_EQ(plannerName(PlannerKind::kRrtConnect), "rrt-connect");
  EXPECT_EQ(plannerFromName("a-star"), std::nullopt);
  EXPECT_EQ(pathStatusName(PathStatus::kNoPath), "no_path");
}

TEST(PathPlanner, growsTheRoadmapUntilItFindsANarrowWay) {
  Scene scene = roomWithGap(2.0 * kRadius + 0.3);
  PathParams params;
  params.roadmapNodes = 10;
  params.growths = 20;
  scene.start.position = {3.0, 1.5};
  scene.goal.position = {9.0, 1.5};
  const FloorPlan plan(scene, kRadius);
  const PathResult result =
      planPath(plan, scene.start.position, scene.goal.position, PlannerKind::kPrm, 1, params);
  EXPECT_EQ(result.status, PathStatus::kFound);
  EXPECT_FALSE(result.usedShortestPath);
}

TEST(PathPlanner, handsOnTheDistancesThatItFoundOut) {
  const Scene scene = roomWithOneBlock();
  const FloorPlan plan(scene, kRadius);
  const auto planned = [&](PlannerKind kind, const PathParams& params) {
    return planPath(plan, scene.start.position, scene.goal.position, kind, 1, params);
  };
  const PathResult result = planned(PlannerKind::kPrm, {});
  ASSERT_NE(result.field, nullptr);
  EXPECT_EQ(result.field->goal(), scene.goal.position);
  EXPECT_NEAR(result.field->metresToGoal(scene.start.position), result.lengthMetres, 0.5);
  EXPECT_EQ(planned(PlannerKind::kRrtConnect, {}).field, nullptr);
  EXPECT_EQ(planned(PlannerKind::kPrm, {.roadmapNodes = 200}).field, nullptr);
}

TEST(Roadmap, findsANarrowGapFromAnySeedWhereTheFieldLeadsThroughIt) {
  Scene scene = roomWithGap(2.0 * kRadius + 0.15);
  scene.start.position = {3.0, 1.5};
  scene.goal.position = {9.0, 1.5};
  const FloorPlan plan(scene, kRadius);
  const DistanceField field(plan, scene.goal.position);
  ASSERT_TRUE(std::isfinite(field.metresToGoal(scene.start.position)));
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Random random(seed);
    const SampledPath sampled = planAlongField(plan, scene.start.position, field, random);
    ASSERT_GE(sampled.path.size(), 3U) << "seed " << seed;
    EXPECT_EQ(sampled.path.front(), scene.start.position);
    EXPECT_EQ(sampled.path.back(), scene.goal.position);
    for (std::size_t i = 1; i < sampled.path.size(); ++i)
      EXPECT_TRUE(plan.isFree(sampled.path[i - 1], sampled.path[i]));
  }
}

TEST(Roadmap, alongAFieldThatDoesNotReachTheStartHasNoPath) {
  const Scene scene = roomWithSealedGoal();
  const FloorPlan plan(scene, kRadius);
  Random random(1);
  EXPECT_TRUE(planAlongField(plan, scene.start.position, DistanceField(plan, scene.goal.position), random)
                  .path.empty());
}

}  // namespace
}  // namespace stridegraph
