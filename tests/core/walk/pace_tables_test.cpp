#include "walk/pace_tables.h"

#include <gtest/gtest.h>

#include "walk/constraint_cost.h"
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
  PaceTables paces{graph, library.frames.framesPerSecond};
};

TEST_F(PaceTablesOfArcs, makesATableOnceForAllWhoAskForTheSamePace) {
  WalkConstraints elsewhere = atMost(1.0);
  elsewhere.areas = {{{{5, 5}, {2, 2}}, AreaKind::kAvoid}};
  elsewhere.latestArrivalSeconds = 20.0;
  const auto first = paces.steering(atMost(1.0));
  const auto other = paces.steering(atMost(2.0));
  EXPECT_NE(first, other);
  EXPECT_EQ(paces.steering(atMost(1.0)), first);
  EXPECT_EQ(paces.steering(elsewhere), first);
  EXPECT_EQ(paces.steering(atMost(2.0)), other);
}

TEST_F(PaceTablesOfArcs, chargesWaysAgainstThePace) {
  const WalkConstraints slow = atMost(0.1);
  const SteeringTable usual(graph, WalkCost{}, library.frames.framesPerSecond);
  EXPECT_GT(paces.steering(slow)->costPerMetre(), 1.2 * usual.costPerMetre());
  EXPECT_EQ(paces.steering(atMost(10.0))->costPerMetre(), usual.costPerMetre());
}

TEST_F(PaceTablesOfArcs, forgetsTheOldestOfManyAndMakesItAgainAlike) {
  const auto first = paces.steering(atMost(1.0));
  for (std::size_t i = 0; i < PaceTables::kMost; ++i)
    paces.steering(atMost(2.0 + 0.1 * static_cast<double>(i)));
  const auto again = paces.steering(atMost(1.0));
  EXPECT_NE(again, first);
  EXPECT_EQ(again->costPerMetre(), first->costPerMetre());
  const Heading aside = Heading::fromAngle(Angle::degrees(70.0));
  for (std::uint32_t node = 0; node < graph.nodeCount(); ++node)
    EXPECT_EQ(again->extraMetres(node, aside), first->extraMetres(node, aside)) << node;
}

}  // namespace
}  // namespace stridegraph
