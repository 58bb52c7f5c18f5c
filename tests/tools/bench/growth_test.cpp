#include "bench/growth.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <vector>

#include "bench/crossing.h"
#include "bench/random_room.h"
#include "bench/varied_clips.h"
#include "graph/library_builder.h"
#include "scene/scene_json.h"
#include "walk/test_gait_library.h"

namespace stridegraph::bench {
namespace {

/// A clock that is a millisecond later whenever it is asked.
MeasureParams countingParams() {
  MeasureParams params;
  params.clock = [now = std::make_shared<double>(0.0)] { return *now += 1.0; };
  return params;
}

std::optional<double> figureOf(const GrowthRow& row, const std::string& name) {
  for (const auto& [figure, value] : row.figures)
    if (figure == name) return value;
  return std::nullopt;
}

Plan arrivedAlong(const std::vector<Vec2>& places, double milliseconds) {
  Plan plan;
  plan.report.status = PlanStatus::kArrived;
  plan.report.totalMilliseconds = milliseconds;
  for (const Vec2& place : places) plan.way.push_back({place, {}});
  for (std::size_t f = 1; f < places.size(); ++f)
    plan.report.motionLengthMetres += (places[f] - places[f - 1]).norm();
  return plan;
}

TEST(CrossingScene, putsEveryoneOppositeToWhereTheyGo) {
  for (const std::size_t walkers : {1U, 2U, 20U, 100U}) {
    const Scene scene = crossingScene(walkers);
    EXPECT_TRUE(checkScene(scene).has_value()) << walkers;
    ASSERT_EQ(scene.walkers.size(), walkers - 1);
    const Vec2 middle(0.5 * scene.widthMetres, 0.5 * scene.depthMetres);
    std::vector<Walker> all = {{scene.start, scene.goal}};
    all.insert(all.end(), scene.walkers.begin(), scene.walkers.end());
    for (std::size_t w = 0; w < walkers; ++w) {
      const Vec2 across = all[w].goal.position - all[w].start.position;
      EXPECT_LT((all[w].start.position + 0.5 * across - middle).norm(), 1e-9);
      EXPECT_GT(Heading::fromAngle(*all[w].start.heading).direction().dot(across.normalized()), 1.0 - 1e-9);
    }
    for (std::size_t w = 1; w < walkers; ++w)
      EXPECT_GT((all[w].start.position - all[w - 1].start.position).norm(), 2.6);
  }
  EXPECT_EQ(crossingScene(20).widthMetres, 20.0);
  EXPECT_NEAR(crossingScene(100).widthMetres, 88.0, 0.1);
}

TEST(Crossing, countsFramesInWhichAnyTwoTouch) {
  const Scene scene = crossingScene(3);
  // The first passes within 0.7 m of the second in one frame, where 0.8 m keep the rims apart; the third has
  // no walk and stays.
  Plan plan = arrivedAlong({{3.0, 3.0}, {4.0, 3.0}, {5.0, 3.0}}, 4.0);
  plan.others = {arrivedAlong({{4.0, 5.0}, {4.0, 3.7}}, 7.0), Plan{}};
  plan.others[1].report.status = PlanStatus::kNoMotion;
  const Crossing crossing = crossingOf(scene, plan);
  EXPECT_EQ(crossing.arrived, 2U);
  EXPECT_EQ(crossing.slowestMilliseconds, 7.0);
  EXPECT_EQ(crossing.contactFrames, 1U);
  EXPECT_NEAR(crossing.leastGapMetres, -0.1, 1e-9);
  EXPECT_NEAR(crossing.meanLengthRatio, 0.5 * (2.0 + 1.3) / 17.0, 1e-9);
}

TEST(GrowthAtWalkers, tellsHowTheCrossingWent) {
  const MeasureParams params = countingParams();
  const GrowthRow one = growthAtWalkers(testing::gaitPlanner(), 1, params);
  EXPECT_EQ(figureOf(one, "arrived"), 1.0);
  EXPECT_FALSE(figureOf(one, "least gap m"));
  const GrowthRow two = growthAtWalkers(testing::gaitPlanner(), 2, params);
  EXPECT_EQ(two.size, 2.0);
  EXPECT_EQ(figureOf(two, "arrived"), 2.0);
  EXPECT_EQ(figureOf(two, "frames of contact"), 0.0);
  EXPECT_GT(*figureOf(two, "least gap m"), 0.0);
  EXPECT_GT(*figureOf(two, "all ms"), *figureOf(two, "slowest walker ms"));
  EXPECT_NEAR(*figureOf(two, "mean length / shortest"), 1.05, 0.05);
}

TEST(GrowthAtFrames, tellsWhatBuildingLeavesOut) {
  const GrowthRow row = growthAtFrames(1000, countingParams());
  ASSERT_TRUE(figureOf(row, "transitions"));
  EXPECT_EQ(figureOf(row, "transitions"), figureOf(row, "transitions found"));
  EXPECT_GT(*figureOf(row, "walk ms"), 0.0);
}

TEST(ThinnedLibrary, walksAsFarAsTheWholeOne) {
  const auto whole = buildLibrary(variedGaitClips(5000, 1));
  const auto thin = buildLibrary(variedGaitClips(5000, 1), {.mostTransitions = 3000});
  ASSERT_TRUE(whole && thin);
  EXPECT_GT(whole->report.transitions, 6000U);
  EXPECT_LE(thin->report.transitions, 3000U);
  EXPECT_GT(thin->report.transitions, 2400U) << "little is lost where stretches do not connect";
  const WalkPlanner wholePlanner(std::make_shared<const MotionLibrary>(whole->library));
  const WalkPlanner thinPlanner(std::make_shared<const MotionLibrary>(thin->library));
  double wholeMetres = 0.0;
  double thinMetres = 0.0;
  for (std::uint64_t number = 1; number <= 5; ++number) {
    const Scene room = randomRoom(1, number);
    const auto first = wholePlanner.plan(room);
    const auto second = thinPlanner.plan(room);
    ASSERT_TRUE(first && second);
    EXPECT_EQ(second->report.status, PlanStatus::kArrived) << second->report.explanation;
    wholeMetres += first->report.motionLengthMetres;
    thinMetres += second->report.motionLengthMetres;
  }
  EXPECT_NEAR(thinMetres / wholeMetres, 1.0, 0.03);
}

}  // namespace
}  // namespace stridegraph::bench
