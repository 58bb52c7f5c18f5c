#include "walk/standing.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "walk/test_library.h"

namespace stridegraph {
namespace {

using testing::kClipFrames;
using testing::threeArcs;
using testing::threeArcsAndAStop;

TEST(StandingFrames, ofABodyThatGoesAreNone) {
  const std::vector<Standing> standing = standingFrames(threeArcs());
  EXPECT_EQ(std::count(standing.begin(), standing.end(), Standing::kNo), 3 * kClipFrames);
}

TEST(StandingFrames, beginWhereAllFiveFramesAroundAreSlowAndSettleLater) {
  const std::vector<Standing> standing = standingFrames(threeArcsAndAStop());
  const std::uint32_t stop = 3 * kClipFrames;
  // Frames 27 and on lie at one place, so that 29 is the first with two like it on either side.
  EXPECT_EQ(standing[stop + 28], Standing::kNo);
  EXPECT_EQ(standing[stop + 29], Standing::kYes);
  EXPECT_EQ(standing[stop + 36], Standing::kYes);
  EXPECT_EQ(standing[stop + 37], Standing::kSettled);
}

TEST(StandingFrames, doNotCountTurningOnTheSpot) {
  MotionLibrary library = threeArcs();
  const std::size_t left = kClipFrames;
  for (std::size_t f = left; f < 2 * left; ++f) library.frames.rootPositions[f] = {0, 1, 0};
  const std::vector<Standing> standing = standingFrames(library);
  EXPECT_EQ(standing[left + 20], Standing::kNo);
}

TEST(IsStill, lookAtTheMeanSpeedOverTheFrames) {
  const MotionLibrary library = threeArcsAndAStop();
  const std::size_t stop = 3 * kClipFrames;
  EXPECT_TRUE(isStill(library.frames, stop + 27, stop + 31));
  // One step of 5 cm in four thirtieths of a second is 0.375 m/s.
  EXPECT_FALSE(isStill(library.frames, stop + 26, stop + 30));
}

}  // namespace
}  // namespace stridegraph
