#include "motion/bvh_reader.h"

#include <gtest/gtest.h>

#include "motion/bvh_texts.h"
#include "motion/kinematics.h"

namespace stridegraph {
namespace {

using testing::kBodyText;
using testing::read;
using testing::replaced;
using testing::replacedAll;
using testing::warningsOf;

void expectSameAsBody(std::string_view text) {
  const BvhDocument body = read(kBodyText);
  const BvhDocument other = read(text);
  EXPECT_EQ(warningsOf(other), "");
  EXPECT_EQ(differenceBetween(body.skeleton, other.skeleton), "");
  EXPECT_LT(testing::greatestDistance(body, other), 1e-12);
  EXPECT_LT(testing::greatestAngleDegrees(body.clip, other.clip), 1e-6);
}

TEST(ReadBvh, understandsJointsUnitsAndMotion) {
  const BvhDocument body = read(kBodyText);
  EXPECT_EQ(warningsOf(body), "");
  ASSERT_EQ(body.skeleton.size(), 5U);
  EXPECT_EQ(body.skeleton.joints[1].name, "chest");
  EXPECT_EQ(body.skeleton.joints[2].name, "chest#end");
  EXPECT_TRUE(body.skeleton.joints[2].isEndSite);
  EXPECT_EQ(body.skeleton.joints[3].parent, JointIndex(std::size_t{0}));
  EXPECT_TRUE(body.skeleton.joints[3].offset.isApprox(Vec3(0, -0.9, 0)));
  EXPECT_EQ(body.layout.unitsPerMetre, 100.0);
  EXPECT_EQ(body.layout.up, UpAxis::kY);
  EXPECT_EQ(body.clip.name, "body.bvh");
  EXPECT_EQ(body.clip.framesPerSecond, 30.0);
  ASSERT_EQ(body.clip.frameCount(), 2U);
  EXPECT_TRUE(body.clip.rootPositions[1].isApprox(Vec3(0.01, 0.9, 0)));
}

TEST(ReadBvh, multipliesRotationsInTheOrderOfTheChannels) {
  const BvhDocument body = read(kBodyText);
  const Quat expected =
      fromEuler({Axis::kZ, Axis::kX, Axis::kY}, {Angle::degrees(40), Angle::degrees(50), Angle::degrees(60)});
  EXPECT_LT(angleBetween(body.clip.rotations[1], expected).degrees(), 1e-6);
  EXPECT_LT(angleBetween(body.clip.rotations[2], Quat::Identity()).degrees(), 1e-6);
}

TEST(ReadBvh, takesAnyLineEndsBlanksAndCase) {
  expectSameAsBody(replacedAll(kBodyText, "\n", "\r\n"));
  expectSameAsBody(replacedAll(kBodyText, "\n", "\r"));
  expectSameAsBody(replaced(replacedAll(kBodyText, "}\n", "}\r\n"), "Frames: 2\n", "Frames: 2\r\n"));
  expectSameAsBody(replacedAll(kBodyText, "\n", " \t \n\n"));
  expectSameAsBody(replacedAll(kBodyText, "\t", "    "));
  expectSameAsBody(kBodyText.substr(0, kBodyText.size() - 1));
  expectSameAsBody("\xEF\xBB\xBF" + std::string(kBodyText));
  expectSameAsBody(replaced(kBodyText, "Frames: 2", "Frames:2"));
  expectSameAsBody(replaced(kBodyText, "Frames: 2", "FRAMES:\t2"));
  expectSameAsBody(replaced(replaced(kBodyText, "HIERARCHY", "hierarchy"), "MOTION", "Motion"));
  expectSameAsBody(replacedAll(replaced(kBodyText, "ROOT", "Root"), "JOINT", "joint"));
  expectSameAsBody(replacedAll(replacedAll(kBodyText, "End Site", "END SITE"), "OFFSET", "offset"));
  expectSameAsBody(replacedAll(replaced(kBodyText, "Frame Time", "frame time"), "rotation", "ROTATION"));
  expectSameAsBody(replacedAll(replacedAll(kBodyText, "\n\t\t{", " {"), "\n\t{", "{"));
  expectSameAsBody(replacedAll(kBodyText, "\n", " \n\v\f"));
}

TEST(ReadBvh, takesNumbersInAnyNotation) {
  expectSameAsBody(replaced(kBodyText, "OFFSET 0 50 0", "OFFSET -0 +5.0e+01 0.0E-5"));
  expectSameAsBody(replaced(kBodyText, "OFFSET 0 -90 0", "OFFSET 0-9000e-2-0"));
  expectSameAsBody(replaced(kBodyText, "OFFSET 0 0 20\n\t\t}", "OFFSET .0 0. 20}"));
}

TEST(ReadBvh, splitsNumbersGluedByAMinusSignButNotExponents) {
  const BvhDocument glued = read(
      replaced(kBodyText, "0 90 0 10 20 30 40 50 60 70 80 85", "1.5-2.25-1e-5 10 20 30 40 50 60 70 80 85"));
  EXPECT_TRUE(glued.clip.rootPositions[0].isApprox(Vec3(0.015, -0.0225, -1e-7), 1e-12));
  EXPECT_EQ(warningsOf(glued), "");
}

TEST(ReadBvh, takesRowsWrappedOverLines) {
  expectSameAsBody(replacedAll(kBodyText, " 40 ", "\n40\n\n"));
}

TEST(ReadBvh, keepsNamesWithBlanksDotsColonsAndDashes) {
  const BvhDocument body = read(
      replaced(replaced(kBodyText, "chest", "Bip01 L.Upper-Arm:x  "), "JOINT leg\n\t{", "JOINT my leg {"));
  EXPECT_EQ(body.skeleton.joints[1].name, "Bip01 L.Upper-Arm:x");
  EXPECT_EQ(body.skeleton.joints[3].name, "my leg");
}

TEST(ReadBvh, takesLeavesWithoutEndSitesAndEndSitesBesideJointsAndWithNames) {
  const BvhDocument body = read(
      replaced(replaced(kBodyText, "\t\tEnd Site\n\t\t{\n\t\t\tOFFSET 0 30 0\n\t\t}\n", ""), "\tJOINT leg",
               "\tEnd Site tail\n\t{ OFFSET 0 0 -5 }\n"
               "\tEnd Site\n\t{ OFFSET 0 80 0 }\n\tJOINT leg"));
  ASSERT_EQ(body.skeleton.size(), 6U);
  EXPECT_TRUE(body.skeleton.childrenOf(JointIndex(std::size_t{1})).empty());
  EXPECT_EQ(body.skeleton.joints[2].name, "hips#end");
  EXPECT_EQ(body.layout.endSiteNames[2], "tail");
  EXPECT_EQ(body.skeleton.joints[3].name, "hips#end2");
  EXPECT_EQ(body.layout.endSiteNames[3], "");
  EXPECT_EQ(body.skeleton.joints[4].name, "leg");
  EXPECT_EQ(warningsOf(body), "");
}

TEST(ReadBvh, takesAnyNumberAndOrderOfChannels) {
  std::string text = replaced(kBodyText, "50 0\n\t\tCHANNELS 3 Zrotation Xrotation Yrotation",
                              "50 0\n\t\tCHANNELS 1 Xrotation");
  text = replaced(text, "-90 0\n\t\tCHANNELS 3 Zrotation Xrotation Yrotation",
                  "-90 0\n\t\tCHANNELS 2 Yrotation Zrotation");
  text = replaced(text, "6 Xposition Yposition Zposition Zrotation Xrotation Yrotation",
                  "6 Yrotation Zposition Xrotation Xposition Zrotation Yposition");
  text = replaced(text, "0 90 0 10 20 30 40 50 60 70 80 85", "10 3 20 1 30 90 40 50 60");
  text = replaced(text, "1 90 0 10 20 30 40 50 60 70 80 85", "10 3 20 1 30 90 40 50 60");
  const BvhDocument body = read(text);
  EXPECT_TRUE(body.clip.rootPositions[0].isApprox(Vec3(0.01, 0.9, 0.03)));
  const Quat root =
      fromEuler({Axis::kY, Axis::kX, Axis::kZ}, {Angle::degrees(10), Angle::degrees(20), Angle::degrees(30)});
  EXPECT_LT(angleBetween(body.clip.rotations[0], root).degrees(), 1e-6);
  EXPECT_LT(angleBetween(body.clip.rotations[1], axisRotation(Axis::kX, Angle::degrees(40))).degrees(), 1e-6);
  const Quat leg = axisRotation(Axis::kY, Angle::degrees(50)) * axisRotation(Axis::kZ, Angle::degrees(60));
  EXPECT_LT(angleBetween(body.clip.rotations[3], leg).degrees(), 1e-6);
  EXPECT_EQ(body.layout.channels[3], (std::vector{BvhChannel::kYRotation, BvhChannel::kZRotation}));
  EXPECT_TRUE(body.layout.channels[4].empty());
}

TEST(ReadBvh, takesJointsWithoutChannels) {
  std::string text = replaced(kBodyText, "50 0\n\t\tCHANNELS 3 Zrotation Xrotation Yrotation", "50 0");
  text = replaced(text, "-90 0\n\t\tCHANNELS 3 Zrotation Xrotation Yrotation", "-90 0\n\t\tCHANNELS 0");
  text = replacedAll(text, " 40 50 60 70 80 85", "");
  const BvhDocument body = read(text);
  EXPECT_EQ(body.clip.frameCount(), 2U);
  EXPECT_EQ(angleBetween(body.clip.rotations[1], Quat::Identity()).degrees(), 0.0);
}

/// The body with six channels at the chest, whose offset there is `first` and `second` in the two frames.
BvhDocument withChestAt(std::string_view first, std::string_view second) {
  std::string text =
      replaced(kBodyText, "50 0\n\t\tCHANNELS 3 ", "7 0\n\t\tCHANNELS 6 Xposition Yposition Zposition ");
  text = replaced(text, "0 90 0 10 20 30 40", "0 90 0 10 20 30 " + std::string(first) + " 40");
  text = replaced(text, "1 90 0 10 20 30 40", "1 90 0 10 20 30 " + std::string(second) + " 40");
  return read(text);
}

TEST(ReadBvh, replacesTheOffsetOfAJointByItsPositionChannels) {
  const BvhDocument body = withChestAt("1 50 2", "1 50 2");
  EXPECT_TRUE(body.skeleton.joints[1].offset.isApprox(Vec3(0.01, 0.5, 0.02), 1e-12));
  EXPECT_EQ(warningsOf(body), "");
  EXPECT_EQ(body.layout.channels[1].size(), 6U);
}

TEST(ReadBvh, takesTheMeanOffsetOfAJointThatMovesAndWarns) {
  const BvhDocument body = withChestAt("0 48 0", "0 52 0");
  EXPECT_TRUE(body.skeleton.joints[1].offset.isApprox(Vec3(0, 0.5, 0), 1e-12));
  EXPECT_EQ(warningsOf(body),
            "body.bvh: joint \"chest\" moves by up to 0.02 m against its parent; its mean offset is used\n");
  EXPECT_EQ(warningsOf(withChestAt("0 49.9 0", "0 50.1 0")), "");
}

TEST(ReadBvh, keepsTheOffsetAlongAxesWithoutPositionChannel) {
  std::string text = replaced(kBodyText, "50 0\n\t\tCHANNELS 3 ", "50 7\n\t\tCHANNELS 4 Xposition ");
  text = replaced(text, "30 40", "30 3 40");
  text = replaced(text, "1 90 0 10 20 30 40", "1 90 0 10 20 30 3 40");
  EXPECT_TRUE(read(text).skeleton.joints[1].offset.isApprox(Vec3(0.03, 0.5, 0.07), 1e-12));
}

TEST(ReadBvh, leavesTheRootOffsetOutOfTheSkeleton) {
  expectSameAsBody(replaced(kBodyText, "OFFSET 0 0 0", "OFFSET 7 8 9"));
  std::string text = replaced(kBodyText, "OFFSET 0 0 0", "OFFSET 7 80 9");
  text = replaced(text, "6 Xposition Yposition Zposition", "3");
  text = replaced(replaced(text, "0 90 0 10", "10"), "1 90 0 10", "10");
  const BvhDocument fixed = read(text);
  EXPECT_TRUE(fixed.skeleton.joints[0].offset.isZero());
  EXPECT_TRUE(fixed.clip.rootPositions[1].isApprox(Vec3(0.07, 0.8, 0.09)));
}

TEST(ReadBvh, usesTheCompleteRowsWhereTheDeclaredFramesDiffer) {
  const BvhDocument fewer = read(replaced(kBodyText, "Frames: 2", "Frames: 3"));
  EXPECT_EQ(fewer.clip.frameCount(), 2U);
  EXPECT_EQ(
      warningsOf(fewer),
      "body.bvh:30:1: 3 frames are declared, 2 complete rows of 12 numbers were found; the complete rows "
      "are used\n");
  const BvhDocument more = read(replaced(kBodyText, "Frames: 2", "Frames: 1"));
  EXPECT_EQ(more.clip.frameCount(), 2U);
  EXPECT_EQ(more.warnings.size(), 1U);
  const BvhDocument torn = read(std::string(kBodyText) + "2 90 0");
  EXPECT_EQ(torn.clip.frameCount(), 2U);
  EXPECT_EQ(warningsOf(torn),
            "body.bvh:30:1: 2 frames are declared, 2 complete rows of 12 numbers and 3 more were found; the "
            "complete rows are used\n");
}

TEST(ReadBvh, takesOneFrame) {
  const BvhDocument one = read(
      replaced(replaced(kBodyText, "Frames: 2", "Frames: 1"), "\n1 90 0 10 20 30 40 50 60 70 80 85", ""));
  EXPECT_EQ(one.clip.frameCount(), 1U);
  EXPECT_EQ(warningsOf(one), "");
}

TEST(ReadBvh, roundsFrameTimesToWholeRatesWithinTheirDigits) {
  const auto rateFor = [](std::string_view seconds) {
    return read(replaced(kBodyText, "0.0333333", seconds)).clip.framesPerSecond;
  };
  EXPECT_EQ(rateFor("0.033333"), 30.0);
  EXPECT_EQ(rateFor("0.033"), 30.0);
  EXPECT_EQ(rateFor(".0083333"), 120.0);
  EXPECT_EQ(rateFor("0.008333"), 120.0);
  EXPECT_EQ(rateFor("0.0333333333333333333"), 30.0);
  EXPECT_EQ(rateFor("0.04"), 25.0);
  EXPECT_EQ(rateFor("1"), 1.0);
  EXPECT_NEAR(rateFor("0.0333667"), 29.97, 1e-4);
  EXPECT_NEAR(rateFor("3.5e-2"), 28.5714, 1e-4);
  EXPECT_NEAR(rateFor("0.0001"), 1e4, 1e-3);
}

TEST(ReadBvh, warnsOfEqualNames) {
  EXPECT_EQ(warningsOf(read(replaced(kBodyText, "leg", "chest"))),
            "body.bvh: more than one joint is named \"chest\"\n");
}

TEST(ReadBvh, takesWhateverFollowsEndForAnEndSite) {
  const auto nameFor = [](std::string_view words) {
    const BvhDocument body = read(replaced(kBodyText, "End Site", words));
    EXPECT_TRUE(body.skeleton.joints[2].isEndSite) << words;
    EXPECT_EQ(body.skeleton.joints[2].name, "chest#end") << words;
    EXPECT_EQ(warningsOf(body), "") << words;
    return body.layout.endSiteNames[2];
  };
  EXPECT_EQ(nameFor("End Site"), "");
  EXPECT_EQ(nameFor("END SITE"), "");
  EXPECT_EQ(nameFor("end site tail"), "tail");
  EXPECT_EQ(nameFor("End Site1"), "Site1");
  EXPECT_EQ(nameFor("End tip_2"), "tip_2");
  EXPECT_EQ(nameFor("End Effector left"), "Effector left");
  EXPECT_EQ(nameFor("End"), "");
  EXPECT_EQ(nameFor("End\n\t\tSite"), "");
  EXPECT_EQ(nameFor("EndSite"), "");
  EXPECT_EQ(nameFor("End_Site tail"), "tail");
}

}  // namespace
}  // namespace stridegraph
