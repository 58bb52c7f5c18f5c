#include "walk/foot_cleanup.h"

#include <gtest/gtest.h>

#include "walk/test_library.h"
#include "walk/test_walker.h"

namespace stridegraph {
namespace {

using namespace testing;

FootCleanupReport clean(SynthesisedWalk& walk) {
  const MotionLibrary library = standingLibrary();
  return FootCleanup(library).apply(library, walk);
}

double lengthOfWay(const std::vector<Vec3>& track) {
  double length = 0.0;
  for (const Vec3& place : track) length = std::max(length, (place - track.front()).norm());
  return length;
}

double kneeDegrees(const SynthesisedWalk& walk, std::size_t frame) {
  return angleBetween(walk.clip.pose(frame).rotations[2], Quat::Identity()).degrees();
}

TEST(FootCleanup, pinsFeetThatSlide) {
  SynthesisedWalk walk = slidingWalk(15, 31, 0.03);
  EXPECT_NEAR(lengthOfWay(trackOf(walk, kLeftTip)), 0.03, 1e-9);
  const FootCleanupReport report = clean(walk);
  for (const std::size_t joint : {kLeftFoot, kLeftTip, kRightFoot, kRightTip})
    EXPECT_LT(lengthOfWay(trackOf(walk, joint)), 0.001) << joint;
  EXPECT_EQ(report.stances, 2U);
  EXPECT_NEAR(report.worstCorrectionMetres, 0.015, 0.001) << "the footprint lies in the middle of the slide";
  EXPECT_NEAR(report.meanCorrectionMetres, 0.0075, 0.001);
  EXPECT_TRUE(report.feetLeftAlone.empty());
}

TEST(FootCleanup, changesNothingButLegsAndHeight) {
  const SynthesisedWalk before = slidingWalk(15, 31, 0.03);
  SynthesisedWalk walk = before;
  clean(walk);
  for (std::size_t f = 0; f < 31; ++f) {
    EXPECT_EQ(onFloor(walk.clip.rootPositions[f]), onFloor(before.clip.rootPositions[f]));
    for (const std::size_t joint : {0, 4, 8, 9, 10, 11, 12})
      EXPECT_EQ(walk.clip.pose(f).rotations[joint].coeffs(), before.clip.pose(f).rotations[joint].coeffs());
  }
}

TEST(FootCleanup, leavesFramesWithoutContactAsTheyAre) {
  SynthesisedWalk before = slidingWalk(15, 20, 0.03);
  for (int f = 0; f < 60; ++f)
    appendFrame(before, standing(15 + 0.2 * f, {0, 1.2, 0.03 + 0.01 * f}), ContactMask{0});
  SynthesisedWalk walk = before;
  clean(walk);
  EXPECT_NE(walk.clip.rotations[2].coeffs(), before.clip.rotations[2].coeffs());
  for (std::size_t f = 30; f < 80; ++f) {
    ASSERT_EQ(walk.clip.rootPositions[f], before.clip.rootPositions[f]) << f;
    for (std::size_t j = 0; j < walk.clip.jointCount; ++j)
      ASSERT_EQ(walk.clip.pose(f).rotations[j].coeffs(), before.clip.pose(f).rotations[j].coeffs()) << f;
  }
}

TEST(FootCleanup, lowersTheHipsInsteadOfSnappingAKnee) {
  // Legs all but straight, pinned while the body goes 4.5 cm to the front and as far to the back.
  SynthesisedWalk walk = slidingWalk(2, 61, 0.09);
  const double height = walk.clip.rootPositions[0].y();
  const double kneeBefore = kneeDegrees(walk, 0);
  const FootCleanupReport report = clean(walk);
  EXPECT_LT(lengthOfWay(trackOf(walk, kLeftTip)), 0.001);
  EXPECT_GT(report.worstLoweringMetres, 0.0005);
  EXPECT_LT(report.worstLoweringMetres, 0.01);
  EXPECT_LT(walk.clip.rootPositions[0].y(), height - 0.0005);
  for (std::size_t f = 1; f < 61; ++f) {
    EXPECT_LT(std::abs(walk.clip.rootPositions[f].y() - walk.clip.rootPositions[f - 1].y()), 0.001) << f;
    EXPECT_LT(std::abs(kneeDegrees(walk, f) - kneeDegrees(walk, f - 1)), 2.0) << f;
    EXPECT_LT(std::abs(kneeDegrees(walk, f) - kneeBefore), 12.0) << f;
  }
}

TEST(FootCleanup, bringsAFloorThatIsTooHighDownWithTheBody) {
  SynthesisedWalk walk = slidingWalk(15, 61, 0.0);
  for (Vec3& root : walk.clip.rootPositions) root.y() += 0.04;
  clean(walk);
  EXPECT_NEAR(trackOf(walk, kLeftTip)[30].y(), 0.015, 1e-6)
      << "stances within 1.5 cm are left where they are";
  EXPECT_NEAR(walk.clip.rootPositions[30].y(), hipHeight(15) + 0.015, 0.002);
}

TEST(FootCleanup, liftsFeetThatSink) {
  SynthesisedWalk walk = slidingWalk(15, 30, 0.0);
  for (std::size_t f = 10; f < 20; ++f) {
    walk.clip.rootPositions[f].y() -= 0.05;
    walk.contacts[f] = 0;
  }
  clean(walk);
  for (const Vec3& tip : trackOf(walk, kLeftTip)) EXPECT_GT(tip.y(), -0.019);
}

TEST(FootCleanup, keepsKneesThatPushOffAsTheyWere) {
  // The heel rises about the tip while the leg stays all but straight; the whole body slides 3 cm.
  SynthesisedWalk walk;
  const double height = hipHeight(2);
  for (std::size_t f = 0; f < 31; ++f) {
    Pose pose = standing(2, {0, height, 0});
    pose.rotations[kLeftFoot] = axisRotation(Axis::kX, Angle::degrees(-2.0 + static_cast<double>(f)));
    const Vec3 tip = jointPositions(walker(), pose.view())[kLeftTip];
    pose.rootPosition += Vec3(0, -tip.y(), -tip.z() + 0.001 * static_cast<double>(f));
    appendFrame(walk, pose, ContactMask{0b0010});
  }
  std::vector<double> before;
  for (std::size_t f = 0; f < 31; ++f) before.push_back(kneeDegrees(walk, f));
  clean(walk);
  EXPECT_LT(lengthOfWay(trackOf(walk, kLeftTip)), 0.005);
  for (std::size_t f = 0; f < 31; ++f) EXPECT_NEAR(kneeDegrees(walk, f), before[f], 2.0) << f;
}

TEST(FootCleanup, leavesAFootWithoutAKneeAloneAndSaysSo) {
  const MotionLibrary library = threeArcs();
  SynthesisedWalk walk = synthesise(
      library, {{}, {{clipPiece(FrameIndex(std::size_t{14}), FrameIndex(std::size_t{26})), 0, 12}}});
  const SynthesisedWalk before = walk;
  const FootCleanupReport report = FootCleanup(library).apply(library, walk);
  EXPECT_EQ(report.feetLeftAlone, std::vector<std::string>{"foot"});
  EXPECT_EQ(report.stances, 0U);
  EXPECT_EQ(walk.clip.rootPositions, before.clip.rootPositions);
}

}  // namespace
}  // namespace stridegraph
