#include "walk/steering.h"

#include <gtest/gtest.h>

#include "walk/test_library.h"

namespace stridegraph {
namespace {

class Steering : public ::testing::Test {
 protected:
  // Arcs that turn by 20, 40, 60 and 80 degrees with the blends before them.
  MotionLibrary library = testing::threeArcs(Angle::degrees(40.0));
  SearchGraph graph{library};
  WalkCost cost;
  SteeringTable table{graph, cost, library.frames.framesPerSecond};

  double extra(std::uint32_t node, double degrees) const {
    return table.extraMetres(node, Heading::fromAngle(Angle::degrees(degrees)));
  }
};

TEST_F(Steering, knowsTheCostOfTheCheapestStraightWalk) {
  // 12 frames of blend and 12 of the clip, straight on, again and again.
  const double metres = 24 * testing::kStepMetres;
  const double seconds = 24 / library.frames.framesPerSecond;
  const double spent =
      metres + cost.perSecond * seconds + cost.perTransition + cost.perTransitionMetre * 0.02;
  EXPECT_NEAR(table.costPerMetre(), spent / metres, 0.01 * spent / metres);
}

TEST_F(Steering, takesNothingMoreToGoStraightOn) {
  EXPECT_NEAR(extra(0, 0.0), 0.0, 0.02);
}

TEST_F(Steering, takesTheMoreTheFartherTheTurn) {
  // From the straight clip into the left one and out again turns by 60 and 20 degrees.
  EXPECT_GT(extra(0, 80.0), extra(0, 0.0) + 0.5);
  EXPECT_GT(extra(0, 160.0), extra(0, 80.0) + 0.5);
}

TEST_F(Steering, isTheSameToBothSidesOfALibraryThatIs) {
  for (const double degrees : {20.0, 80.0, 160.0}) {
    EXPECT_NEAR(extra(0, degrees), extra(0, -degrees), 0.02) << degrees;
    EXPECT_NEAR(extra(1, degrees), extra(2, -degrees), 0.02) << degrees;
  }
}

TEST_F(Steering, isContinuousAcrossNorth) {
  EXPECT_NEAR(extra(0, 359.99), extra(0, 0.01), 0.01);
}

}  // namespace
}  // namespace stridegraph
