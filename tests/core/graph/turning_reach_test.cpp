#include "graph/turning_reach.h"

#include <gtest/gtest.h>

#include "graph/test_library.h"

namespace stridegraph {
namespace {

using testing::builtFrom;
using testing::documentOf;
using testing::walkOf;

std::vector<BvhDocument> walksAt(std::initializer_list<double> degreesPerSecond) {
  std::vector<BvhDocument> documents;
  for (const double degrees : degreesPerSecond)
    documents.push_back(documentOf(walkOf({.frames = 80, .turnPerSecond = Angle::degrees(degrees)}), "walk"));
  return documents;
}

TEST(TurningReach, ofOneSteadyWalkIsItsOwnTurning) {
  for (const double degrees : {0.0, 30.0, -20.0}) {
    const auto reach = turningReachOf(builtFrom(walksAt({degrees})).library);
    ASSERT_TRUE(reach);
    EXPECT_NEAR(reach->leastPerSecond.degrees(), degrees, 0.1);
    EXPECT_NEAR(reach->mostPerSecond.degrees(), degrees, 0.1);
  }
}

TEST(TurningReach, goesFromTheOneWalkToTheOther) {
  const auto reach = turningReachOf(builtFrom(walksAt({10.0, -25.0, 35.0})).library);
  ASSERT_TRUE(reach);
  EXPECT_NEAR(reach->leastPerSecond.degrees(), -25.0, 0.5);
  EXPECT_NEAR(reach->mostPerSecond.degrees(), 35.0, 0.5);
}

}  // namespace
}  // namespace stridegraph
