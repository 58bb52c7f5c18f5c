#include "walk/footprints.h"

#include <gtest/gtest.h>

#include <cmath>

#include "walk/test_walker.h"

namespace stridegraph {
namespace {

using namespace testing;

FootTrack leftTrack(const SynthesisedWalk& walk) {
  const MotionLibrary library = standingLibrary();
  return trackFoot(library, findWalkFeet(library).feet[0], walk.clip, walk.contacts);
}

const std::vector<double> kLevels = {0.05, 0.0};

TEST(FindStances, areRunsOfContactThatLast) {
  SynthesisedWalk walk = slidingWalk(15, 40, 0.0);
  for (const std::size_t f : {10, 20, 21, 24, 25}) walk.contacts[f] = 0;
  const std::vector<FootStance> stances = findStances(leftTrack(walk));
  ASSERT_EQ(stances.size(), 3U) << "the touch in frames 22 and 23 is too short";
  EXPECT_EQ(stances[0].first, 0U);
  EXPECT_EQ(stances[0].last, 9U);
  EXPECT_EQ(stances[1].last, 19U);
  EXPECT_EQ(stances[2].first, 26U);
}

TEST(StandingHeights, areNotKnownOfJointsThatNeverStand) {
  SynthesisedWalk walk = slidingWalk(15, 10, 0.0);
  for (ContactMask& mask : walk.contacts) mask = 0b0010;
  const std::vector<double> heights = standingHeights(leftTrack(walk), {0, 9});
  EXPECT_TRUE(std::isnan(heights[0]));
  EXPECT_NEAR(heights[1], 0.0, 1e-9);
}

TEST(PinStances, keepsHeelAndTipEachInOnePlaceWhileTheFootRolls) {
  // Heel first, then both, then the tip, while the foot slides by 2 cm.
  SynthesisedWalk walk = slidingWalk(15, 30, 0.02);
  for (std::size_t f = 0; f < 30; ++f) walk.contacts[f] = f < 8 ? 0b01 : f < 20 ? 0b11 : 0b10;
  const FootTrack track = leftTrack(walk);
  const std::vector<PinnedStance> pinned = pinStances(track, kLevels);
  ASSERT_EQ(pinned.size(), 1U);
  for (std::size_t k = 0; k < 2; ++k) {
    const std::size_t first = k == 0 ? 0 : 8;
    const std::size_t last = k == 0 ? 19 : 29;
    for (std::size_t f = first; f <= last; ++f) {
      const auto placeAt = [&](std::size_t frame) {
        return Vec3(track.points[k][frame] + pinned[0].corrections[frame].head<3>());
      };
      EXPECT_LT((placeAt(f) - placeAt(first)).norm(), 1e-4) << k << " at " << f;
    }
  }
}

TEST(PinStances, holdsTheYawOfAFlatFoot) {
  SynthesisedWalk walk = slidingWalk(15, 31, 0.0);
  for (std::size_t f = 0; f < 31; ++f) {
    Quat& root = walk.clip.rotationsOf(f)[0];
    root = axisRotation(Axis::kY, Angle::degrees(0.2 * static_cast<double>(f)));
  }
  const FootTrack track = leftTrack(walk);
  const std::vector<PinnedStance> pinned = pinStances(track, kLevels);
  ASSERT_EQ(pinned.size(), 1U);
  for (std::size_t f = 0; f < 31; ++f)
    EXPECT_NEAR(track.headings[f].angle().radians() + pinned[0].corrections[f][3],
                Angle::degrees(3).radians(), 1e-6);
}

TEST(PinStances, dividesAStanceThatWandersTooFar) {
  const std::vector<PinnedStance> pinned = pinStances(leftTrack(slidingWalk(15, 91, 0.25)), kLevels);
  EXPECT_GT(pinned.size(), 1U);
  for (const PinnedStance& one : pinned) {
    for (const FootCorrection& correction : one.corrections)
      EXPECT_LE(std::hypot(correction[0], correction[2]), PinParams{}.farthestMetres);
  }
}

TEST(PinStances, letsGoOfAFootThatIsPulledAlong) {
  SynthesisedWalk walk = slidingWalk(15, 20, 0.0);
  for (std::size_t f = 17; f < 20; ++f) walk.clip.rootPositions[f].z() += 0.012 * static_cast<double>(f - 16);
  const std::vector<PinnedStance> pinned = pinStances(leftTrack(walk), kLevels);
  ASSERT_EQ(pinned.size(), 1U);
  EXPECT_EQ(pinned[0].stance.last, 16U);
  EXPECT_EQ(pinned[0].corrections.size(), 17U);
}

TEST(PinStances, bringsStancesToWithinTheToleranceOfTheirLevel) {
  for (const double height : {0.04, 0.01, -0.04}) {
    SynthesisedWalk walk = slidingWalk(15, 20, 0.0);
    for (Vec3& root : walk.clip.rootPositions) root.y() += height;
    const double expected = height > 0.015 ? 0.015 - height : height < -0.015 ? -0.015 - height : 0.0;
    EXPECT_NEAR(pinStances(leftTrack(walk), kLevels)[0].corrections[10][1], expected, 1e-9);
  }
}

}  // namespace
}  // namespace stridegraph
