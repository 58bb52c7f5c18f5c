#include "motion/facing.h"

#include <gtest/gtest.h>

#include "motion/test_motions.h"

namespace stridegraph {
namespace {

using testing::walkOf;

/// The walk with its root turned on the body, as if it had been captured with other axes.
Clip withRootTurned(Clip clip, Angle turn) {
  for (std::size_t f = 0; f < clip.frameCount(); ++f)
    clip.rotationsOf(f)[0] = clip.rotationsOf(f)[0] * axisRotation(Axis::kY, turn);
  return clip;
}

TEST(FacingOffset, isZeroWhereTheRootLooksAhead) {
  const std::vector<Clip> clips = {walkOf({}), walkOf({.turnPerSecond = Angle::degrees(60)})};
  // Steps of an arc are seen from their beginning: half a step's turn, 1 degree, in half of the steps.
  EXPECT_NEAR(facingOffset(clips).angle().degrees(), 0.0, 0.6);
}

TEST(FacingOffset, isTheTurnOfARootThatLooksSideways) {
  const std::vector<Clip> clips = {withRootTurned(walkOf({}), Angle::degrees(-83))};
  EXPECT_NEAR(facingOffset(clips).angle().degrees(), -83.0, 0.5);
}

TEST(FacingOffset, isAMeanOnTheCircle) {
  const std::vector<Clip> clips = {withRootTurned(walkOf({}), Angle::degrees(175)),
                                   withRootTurned(walkOf({}), Angle::degrees(-175))};
  EXPECT_NEAR(std::abs(facingOffset(clips).angle().degrees()), 180.0, 0.5);
}

TEST(FacingOffset, leavesSlowFramesOut) {
  const std::vector<Clip> clips = {walkOf({}),
                                   withRootTurned(walkOf({.speedMetresPerSecond = 0.2}), Angle::degrees(90))};
  EXPECT_NEAR(facingOffset(clips).angle().degrees(), 0.0, 0.5);
  EXPECT_GT(facingOffset(clips, {.minimumSpeedMetresPerSecond = 0.1}).angle().degrees(), 30.0);
}

TEST(FacingOffset, isZeroWhenNothingMoves) {
  const std::vector<Clip> clips = {withRootTurned(walkOf({.speedMetresPerSecond = 0.0}), Angle::degrees(40))};
  EXPECT_EQ(facingOffset(clips).angle().degrees(), 0.0);
}

}  // namespace
}  // namespace stridegraph
