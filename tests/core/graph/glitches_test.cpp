#include "graph/glitches.h"

#include <gtest/gtest.h>

#include "motion/test_motions.h"

namespace stridegraph {
namespace {

using testing::walkOf;

constexpr std::size_t kArm = 10;

/// A walk whose arm turns about z by these further degrees from frame to frame, from frame `first` on.
Clip withArmTurning(std::size_t first, const std::vector<double>& degrees) {
  Clip clip = walkOf({.frames = 40});
  double angle = 0.0;
  for (std::size_t f = first; f < clip.frameCount(); ++f) {
    if (f - first < degrees.size()) angle += degrees[f - first];
    Quat& arm = clip.rotationsOf(f)[kArm];
    arm = arm * axisRotation(Axis::kZ, Angle::degrees(angle));
  }
  return clip;
}

TEST(FindGlitches, findsAJumpThatStays) {
  const std::vector<Glitch> glitches = findGlitches(withArmTurning(12, {60}));
  ASSERT_EQ(glitches.size(), 1U);
  EXPECT_EQ(glitches[0].frame, 11U);
  EXPECT_EQ(glitches[0].joint, JointIndex(kArm));
  EXPECT_NEAR(glitches[0].turn.degrees(), 60.0, 5.0);
}

TEST(FindGlitches, findsBothSidesOfASingleWrongFrame) {
  const std::vector<Glitch> glitches = findGlitches(withArmTurning(12, {60, -60}));
  ASSERT_EQ(glitches.size(), 2U);
  EXPECT_EQ(glitches[0].frame, 11U);
  EXPECT_EQ(glitches[1].frame, 12U);
}

TEST(FindGlitches, findsAJumpAtTheVeryBeginningOrEnd) {
  EXPECT_EQ(findGlitches(withArmTurning(1, {81})).size(), 1U);
  EXPECT_EQ(findGlitches(withArmTurning(39, {81})).size(), 1U);
}

TEST(FindGlitches, leavesFastMotionAlone) {
  EXPECT_TRUE(findGlitches(walkOf({.frames = 40})).empty());
  EXPECT_TRUE(findGlitches(withArmTurning(12, {15, 30, 50, 30, 15})).empty());
  EXPECT_TRUE(findGlitches(withArmTurning(12, {39})).empty());
}

TEST(CutAtGlitches, leavesNoPieceAcrossAJumpAndNoSingleFrame) {
  const Clip clip = withArmTurning(12, {60, -60});
  const std::vector<Clip> pieces = cutAtGlitches(clip, findGlitches(clip));
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].name, "walk");
  EXPECT_EQ(pieces[0].frameCount(), 12U);
  EXPECT_EQ(pieces[1].name, "walk from frame 13");
  EXPECT_EQ(pieces[1].frameCount(), 27U);
  EXPECT_EQ(pieces[1].rootPositions[0], clip.rootPositions[13]);
}

TEST(CutAtGlitches, givesASoundClipBackWhole) {
  const std::vector<Clip> pieces = cutAtGlitches(walkOf({.frames = 40}), {});
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].frameCount(), 40U);
}

}  // namespace
}  // namespace stridegraph
