#include "walk/walk_feet.h"

#include <gtest/gtest.h>

#include "walk/test_library.h"
#include "walk/test_walker.h"

namespace stridegraph {
namespace {

using namespace testing;

TEST(LegAbove, isFoundFromAnkleAndFromTip) {
  for (const std::size_t joint : {kLeftFoot, kLeftTip}) {
    const std::optional<Leg> leg = legAbove(walker(), JointIndex(joint));
    ASSERT_TRUE(leg.has_value());
    EXPECT_EQ(leg->hip, JointIndex(std::size_t{1}));
    EXPECT_EQ(leg->knee, JointIndex(std::size_t{2}));
    EXPECT_EQ(leg->ankle, JointIndex(kLeftFoot));
  }
}

TEST(LegAbove, doesNotTakeTheRootForAHip) {
  EXPECT_FALSE(legAbove(oneLeg(), JointIndex(std::size_t{2})).has_value()) << "its hip is the root";
  EXPECT_FALSE(legAbove(threeArcs().skeleton, JointIndex(std::size_t{1})).has_value());
}

TEST(LegAbove, refusesBonesOfVeryDifferentLength) {
  Skeleton skeleton = walker();
  skeleton.joints[2].offset = {0, -0.05, 0};
  skeleton.joints[kLeftTip].offset = {0, 0, 0.01};
  EXPECT_FALSE(legAbove(skeleton, JointIndex(kLeftFoot)).has_value());
}

TEST(FindWalkFeet, measuresHowKneesBendAndFeetStand) {
  const WalkFeet found = findWalkFeet(standingLibrary());
  ASSERT_EQ(found.feet.size(), 2U);
  EXPECT_EQ(found.feet[0].contacts, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(found.feet[1].contacts, (std::vector<std::size_t>{2, 3}));
  for (const WalkFoot& foot : found.feet) {
    EXPECT_NEAR(foot.legMetres, 0.85, 1e-9);
    EXPECT_TRUE(foot.leg.bendAxis.isApprox(Vec3::UnitX(), 1e-9)) << "knees bend to the front";
    EXPECT_TRUE(foot.sideInAnkle.isApprox(Vec3::UnitX(), 1e-9)) << "left is +x";
  }
}

TEST(TrackFoot, holdsTheMoreTheSlowerAJointIs) {
  const MotionLibrary library = standingLibrary();
  const WalkFeet found = findWalkFeet(library);
  const auto holdAt = [&](double metresPerSecond) {
    const SynthesisedWalk walk = slidingWalk(15, 31, metresPerSecond);
    return trackFoot(library, found.feet[0], walk.clip, walk.contacts).holds[0][15];
  };
  EXPECT_NEAR(holdAt(0.0), 1.0, 1e-9);
  EXPECT_NEAR(holdAt(0.3), 0.25, 1e-9);
  EXPECT_EQ(holdAt(0.61), 0.0);
}

TEST(TrackFoot, holdsNothingWithoutContact) {
  const MotionLibrary library = standingLibrary();
  SynthesisedWalk walk = slidingWalk(15, 31, 0.0);
  walk.contacts[15] = 0b0010;
  const FootTrack track = trackFoot(library, findWalkFeet(library).feet[0], walk.clip, walk.contacts);
  EXPECT_EQ(track.holds[0][15], 0.0);
  EXPECT_EQ(track.holds[1][15], 1.0);
}

TEST(TrackFoot, tellsTheYawOfAFootHoweverItIsPitched) {
  const MotionLibrary library = standingLibrary();
  SynthesisedWalk walk = slidingWalk(15, 3, 0.0);
  for (std::size_t f = 0; f < 3; ++f) {
    Quat& root = walk.clip.rotationsOf(f)[0];
    root = axisRotation(Axis::kY, Angle::degrees(40)) *
           axisRotation(Axis::kX, Angle::degrees(60.0 * static_cast<double>(f))) * root;
  }
  const FootTrack track = trackFoot(library, findWalkFeet(library).feet[0], walk.clip, walk.contacts);
  for (const Heading& heading : track.headings) EXPECT_NEAR(heading.angle().degrees(), 40.0, 1e-7);
}

}  // namespace
}  // namespace stridegraph
