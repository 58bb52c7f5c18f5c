#include "walk/constraint_cost.h"

#include <gtest/gtest.h>

namespace stridegraph {
namespace {

constexpr double kFramesPerSecond = 30.0;

SearchEdge wayOf(double metres, std::uint32_t frames) {
  SearchEdge way;
  way.lengthMetres = metres;
  way.sampleCount = frames;
  return way;
}

TEST(ConstraintCost, isNothingWhereNothingIsAskedFor) {
  const WalkConstraints none;
  const ConstraintCost cost(none, kFramesPerSecond);
  EXPECT_EQ(cost.ofPace(wayOf(3.0, 30)), 0.0);
  EXPECT_EQ(cost.perMetreAt({1, 1}), 0.0);
  EXPECT_FALSE(none.asksForPace());
  EXPECT_FALSE(cost.asksForPlaces());
}

TEST(ConstraintCost, chargesTheOtherGaitForItsTime) {
  WalkConstraints constraints;
  constraints.gait = Gait::kWalk;
  const ConstraintCost cost(constraints, kFramesPerSecond);
  EXPECT_EQ(cost.ofPace(wayOf(1.3, 30)), 0.0);
  EXPECT_GT(cost.ofPace(wayOf(2.5, 30)), 0.0);
  EXPECT_NEAR(cost.ofPace(wayOf(5.0, 60)), 2.0 * cost.ofPace(wayOf(2.5, 30)), 1e-12);
}

TEST(ConstraintCost, chargesSpeedsOutsideOfTheRange) {
  WalkConstraints constraints;
  constraints.minSpeedMetresPerSecond = 0.8;
  constraints.maxSpeedMetresPerSecond = 1.2;
  EXPECT_TRUE(keepsTo(constraints, 0.8));
  EXPECT_TRUE(keepsTo(constraints, 1.24));
  EXPECT_FALSE(keepsTo(constraints, 1.26));
  EXPECT_FALSE(keepsTo(constraints, 0.7));
}

TEST(ConstraintCost, chargesWhoIsTooSlowTheMoreTheFartherBehindUpToAPrice) {
  WalkConstraints constraints;
  constraints.gait = Gait::kRun;
  const ConstraintCost cost(constraints, kFramesPerSecond);
  EXPECT_EQ(cost.perSecondAt(kRunMetresPerSecond + 0.01), 0.0);
  EXPECT_GT(cost.perSecondAt(1.85), 0.0);
  EXPECT_GT(cost.perSecondAt(1.75), cost.perSecondAt(1.85));
  EXPECT_GT(cost.perSecondAt(1.3), cost.perSecondAt(1.75));
  EXPECT_EQ(cost.perSecondAt(0.0), cost.perSecondAt(1.3));
}

TEST(ConstraintCost, makesABeginningInMotionDearWhereAStandIsTooSlow) {
  WalkConstraints run;
  run.gait = Gait::kRun;
  WalkConstraints walk;
  walk.gait = Gait::kWalk;
  EXPECT_GE(ConstraintCost(run, kFramesPerSecond).ofMovingStart(),
            2.0 * ConstraintCost(run, kFramesPerSecond).perSecondAt(0.0));
  EXPECT_EQ(ConstraintCost(walk, kFramesPerSecond).ofMovingStart(), 0.0);
}

TEST(ConstraintCost, chargesMetresInAreasToAvoidAndOutsideOfPreferredOnes) {
  WalkConstraints constraints;
  constraints.areas = {{{{5, 5}, {2, 2}}, AreaKind::kAvoid}, {{{9, 5}, {2, 2}}, AreaKind::kPrefer}};
  const ConstraintCost cost(constraints, kFramesPerSecond);
  EXPECT_EQ(cost.perMetreAt({9, 5}), 0.0);
  EXPECT_GT(cost.perMetreAt({1, 1}), 0.0);
  EXPECT_GT(cost.perMetreAt({5, 5}), cost.perMetreAt({1, 1}));
  const std::vector<Eigen::Vector2f> ahead = {{0.0F, 0.1F}, {0.0F, 0.2F}};
  EXPECT_NEAR(cost.ofPlaces({{5, 5}, {}}, ahead), 0.2 * cost.perMetreAt({5, 5}), 1e-6);
}

}  // namespace
}  // namespace stridegraph
