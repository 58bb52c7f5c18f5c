#include "walk/pace_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "walk/constraint_cost.h"
#include "walk/test_gait_library.h"
#include "walk/test_library.h"

namespace stridegraph {
namespace {

WalkConstraints atMost(double metresPerSecond) {
  WalkConstraints wishes;
  wishes.maxSpeedMetresPerSecond = metresPerSecond;
  return wishes;
}

class PaceTablesOfArcs : public ::testing::Test {
 protected:
  MotionLibrary library = testing::threeArcs(Angle::degrees(40.0));
  SearchGraph graph{library};
  SteeringTable usual{graph, WalkCost{}, library.frames.framesPerSecond};
  PaceTables paces{graph, usual, library.frames.framesPerSecond};
};

TEST_F(PaceTablesOfArcs, makesATableOnceForAllWhoAskForTheSamePace) {
  WalkConstraints elsewhere = atMost(1.0);
  elsewhere.areas = {{{{5, 5}, {2, 2}}, AreaKind::kAvoid}};
  elsewhere.latestArrivalSeconds = 20.0;
  const auto first = paces.of(atMost(1.0));
  const auto other = paces.of(atMost(2.0));
  EXPECT_NE(first, other);
  EXPECT_EQ(paces.of(atMost(1.0)), first);
  EXPECT_EQ(paces.of(elsewhere), first);
  EXPECT_EQ(paces.of(atMost(2.0)), other);
}

TEST_F(PaceTablesOfArcs, chargesWaysAgainstThePace) {
  const WalkConstraints slow = atMost(0.1);
  EXPECT_GT(paces.of(slow)->steering.costPerMetre(), 1.2 * usual.costPerMetre());
  EXPECT_EQ(paces.of(atMost(10.0))->steering.costPerMetre(), usual.costPerMetre());
}

TEST_F(PaceTablesOfArcs, forgetsTheOldestOfManyAndMakesItAgainAlike) {
  const auto first = paces.of(atMost(1.0));
  for (std::size_t i = 0; i < PaceTables::kMost; ++i) paces.of(atMost(2.0 + 0.1 * static_cast<double>(i)));
  const auto again = paces.of(atMost(1.0));
  EXPECT_NE(again, first);
  EXPECT_EQ(again->steering.costPerMetre(), first->steering.costPerMetre());
  const Heading aside = Heading::fromAngle(Angle::degrees(70.0));
  for (std::uint32_t node = 0; node < graph.nodeCount(); ++node)
    EXPECT_EQ(again->steering.extraMetres(node, aside), first->steering.extraMetres(node, aside)) << node;
}

TEST_F(PaceTablesOfArcs, knowsTheFastestGoingOfALibraryThatGoesAtOneSpeed) {
  const auto hurry = paces.hurry();
  const double metresPerSecond = testing::kStepMetres * library.frames.framesPerSecond;
  EXPECT_NEAR(hurry->secondsPerMetre, 1.0 / metresPerSecond, 0.01 / metresPerSecond);
  EXPECT_NEAR(hurry->secondsTo(0, 3.0, false), 3.0 / metresPerSecond, 0.05);
  EXPECT_EQ(paces.hurry(), hurry);
}

/// With the page's clips, which stand, walk and run.
class PaceTablesOfGaits : public ::testing::Test {
 protected:
  const MotionLibrary& library = testing::gaitPlanner().library();
  SearchTables tables{library};
  PaceTables paces{tables.graph, tables.steering, library.frames.framesPerSecond};
};

TEST_F(PaceTablesOfGaits, chargesARunnerForComingToAStandMoreThanAWalker) {
  WalkConstraints run;
  run.gait = Gait::kRun;
  WalkConstraints walk;
  walk.gait = Gait::kWalk;
  EXPECT_GT(paces.of(run)->stopMetres, paces.of(walk)->stopMetres + 1.0);
  EXPECT_GT(paces.of(run)->unhurriedPerMetre, 0.5);
  EXPECT_EQ(paces.of(walk)->unhurriedPerMetre, 0.0);
  for (const double metres : paces.of(run)->standMetres) EXPECT_TRUE(std::isfinite(metres) && metres >= 0.0);
}

TEST_F(PaceTablesOfGaits, needsTimeToGetGoingAndToStop) {
  const auto hurry = paces.hurry();
  // The fastest clip runs at 3 m/s.
  EXPECT_NEAR(1.0 / hurry->secondsPerMetre, 2.95, 0.1);
  EXPECT_GT(hurry->stopSeconds, 0.5);
  EXPECT_LT(hurry->stopSeconds, 4.0);
  EXPECT_NEAR(hurry->secondsTo(0, 20.0, true) - hurry->secondsTo(0, 20.0, false), hurry->stopSeconds, 1e-12);
  double longest = 0.0;
  for (const double seconds : hurry->goingSeconds) longest = std::max(longest, seconds);
  EXPECT_GT(longest, 1.0);
}

}  // namespace
}  // namespace stridegraph
