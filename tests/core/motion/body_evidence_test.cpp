#include "motion/body_evidence.h"

#include <gtest/gtest.h>

#include "motion/test_motions.h"

namespace stridegraph {
namespace {

constexpr std::size_t kUp = 2;

TEST(BodyEvidence, measuresExtentsPosedAndAtRest) {
  const BodyEvidence evidence = gatherEvidence(testing::walker(), testing::walkOf({}));
  EXPECT_NEAR(evidence.extents.rest.y(), 1.4, 1e-9);
  EXPECT_NEAR(evidence.extents.posed.y(), 1.4, 0.05);
  EXPECT_EQ(evidence.size, std::max(evidence.extents.posed.y(), evidence.extents.rest.y()));
}

TEST(BodyEvidence, seesWhereTheRootGoesAndThatTheLowestJointStays) {
  const Clip walk = testing::walkOf({.frames = 61, .speedMetresPerSecond = 1.2});
  const BodyEvidence evidence = gatherEvidence(testing::walker(), walk);
  EXPECT_NEAR(evidence.rootRange.z(), 2.4, 1e-9);
  EXPECT_EQ(evidence.rootRange.y(), 0.0);
  EXPECT_LT(evidence.levelSpread[kUp], 0.1);
  EXPECT_GT(evidence.levelSpread[4], 1.5);
  ASSERT_TRUE(evidence.slip);
  EXPECT_LT((*evidence.slip)[kUp], (*evidence.slip)[3]);
}

TEST(BodyEvidence, hasNoSlipOfABodyThatStands) {
  EXPECT_FALSE(
      gatherEvidence(testing::walker(), testing::walkOf({.speedMetresPerSecond = 0.0})).slip.has_value());
}

TEST(BodyEvidence, findsHeadAndFeetByTheirNames) {
  Skeleton skeleton = testing::walker();
  const Clip clip = testing::walkOf({.frames = 1});
  EXPECT_TRUE(gatherEvidence(skeleton, clip).hasFeet);
  EXPECT_FALSE(gatherEvidence(skeleton, clip).hasHead);
  EXPECT_FALSE(gatherEvidence(skeleton, clip).feetToHead);
  skeleton.joints[9].name = "HEAD";
  ASSERT_TRUE(gatherEvidence(skeleton, clip).feetToHeadAtRest);
  EXPECT_NEAR(gatherEvidence(skeleton, clip).feetToHeadAtRest->y(), 0.5 + 0.85, 1e-9);
  EXPECT_GT(gatherEvidence(skeleton, clip).feetToHead->y(), 1.2);
}

TEST(BodyEvidence, ofNoFramesIsThatOfTheRestPose) {
  Clip empty = testing::walkOf({.frames = 1});
  empty.rootPositions.clear();
  empty.rotations.clear();
  const BodyEvidence evidence = gatherEvidence(testing::walker(), empty);
  EXPECT_NEAR(evidence.size, 1.4, 1e-9);
  EXPECT_TRUE(evidence.extents.posed.isZero());
}

}  // namespace
}  // namespace stridegraph
