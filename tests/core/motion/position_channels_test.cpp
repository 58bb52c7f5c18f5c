#include "motion/position_channels.h"

#include <gtest/gtest.h>

#include "math/random.h"
#include "motion/bvh_interpretation.h"
#include "motion/bvh_texts.h"
#include "motion/parsed_motions.h"
#include "motion/test_motions.h"

namespace stridegraph {
namespace {

using testing::kSixChannels;
using testing::ParsedBvh;
using testing::warningsOf;

constexpr double kCentimetres = 100.0;

/// The walker with six channels everywhere and its walk. `positionOf(joint, frame)` says what stands in the
/// position channels of joints below the root, in centimetres.
template <typename PositionOf>
ParsedBvh walkWith(PositionOf positionOf) {
  const Skeleton walker = testing::walker();
  const Clip clip = testing::walkOf({.frames = 30});
  ParsedBvh parsed;
  for (const Joint& joint : walker.joints) {
    const auto parent = joint.parent ? std::optional<std::size_t>(joint.parent->value) : std::nullopt;
    if (joint.isEndSite) {
      parsed.addEndSite(*parent, joint.offset * kCentimetres);
    } else {
      parsed.addJoint(joint.name, parent, joint.offset * kCentimetres, kSixChannels);
    }
  }
  parsed.setFrames(clip.frameCount());
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    parsed.place(0, f, clip.rootPositions[f] * kCentimetres, clip.pose(f).rotations[0]);
    for (std::size_t j = 1; j < walker.size(); ++j)
      parsed.place(j, f, positionOf(j, f), clip.pose(f).rotations[j]);
  }
  return parsed;
}

Vec3 offsetOf(std::size_t joint) {
  return testing::walker().joints[joint].offset * kCentimetres;
}

BvhDocument interpreted(const ParsedBvh& parsed) {
  Result<BvhDocument> document =
      interpretBvh(parsed.hierarchy, parsed.motion, "body.bvh", {kCentimetres, UpAxis::kY});
  EXPECT_TRUE(document) << describe(document.error());
  return document ? *std::move(document) : BvhDocument{};
}

std::string differenceFromWalker(const BvhDocument& document, double toleranceMetres = 1e-9) {
  return differenceBetween(testing::walker(), document.skeleton, toleranceMetres);
}

TEST(PositionChannels, replaceOffsets) {
  const auto taller = [](std::size_t joint, std::size_t) { return Vec3(1.2 * offsetOf(joint)); };
  const BvhDocument document = interpreted(walkWith(taller));
  EXPECT_EQ(warningsOf(document), "");
  EXPECT_TRUE(document.skeleton.joints[2].offset.isApprox(Vec3(0, -0.54, 0), 1e-9));
}

TEST(PositionChannels, leaveOffsetsInForceWhereAllAreZero) {
  const BvhDocument document = interpreted(walkWith([](std::size_t, std::size_t) { return Vec3(0, 0, 0); }));
  EXPECT_EQ(differenceFromWalker(document), "");
  ASSERT_EQ(document.warnings.size(), 1U);
  EXPECT_EQ(document.warnings[0].topic, WarningTopic::kSkeleton);
  EXPECT_EQ(
      warningsOf(document),
      "body.bvh: the position channels of \"leftThigh\", \"leftShin\", \"leftFoot\" and 6 more are 0 in "
      "every row: their OFFSETs stay in force\n");
}

TEST(PositionChannels, leaveOffsetsInForceWhereSomeAreZero) {
  const auto someZero = [](std::size_t joint, std::size_t) {
    return joint == 2 ? Vec3(0, 0, 0) : offsetOf(joint);
  };
  const BvhDocument document = interpreted(walkWith(someZero));
  EXPECT_EQ(differenceFromWalker(document), "");
  EXPECT_EQ(
      warningsOf(document),
      "body.bvh: the position channels of \"leftShin\" are 0 in every row: its OFFSET stays in force\n");
}

TEST(PositionChannels, leaveTheOffsetOfARootInForceWhereItsAreZero) {
  ParsedBvh parsed = walkWith([](std::size_t joint, std::size_t) { return offsetOf(joint); });
  parsed.hierarchy.joints[0].offset = Vec3(0, 95, 0);
  for (std::size_t f = 0; f < parsed.motion.frameCount; ++f)
    parsed.place(0, f, Vec3::Zero(), Quat::Identity());
  const BvhDocument document = interpreted(parsed);
  EXPECT_TRUE(document.clip.rootPositions[3].isApprox(Vec3(0, 0.95, 0), 1e-12));
  EXPECT_EQ(warningsOf(document),
            "body.bvh: the position channels of \"hips\" are 0 in every row: its OFFSET stays in force\n");
}

TEST(PositionChannels, addToOffsetsWhereTheBonesWouldBeLost) {
  Random random(3);
  const auto shift = [&](std::size_t, std::size_t) {
    return Vec3(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2));
  };
  const BvhDocument document = interpreted(walkWith(shift));
  EXPECT_EQ(differenceFromWalker(document, 0.003), "");
  ASSERT_EQ(document.warnings.size(), 1U);
  EXPECT_EQ(
      warningsOf(document),
      "body.bvh: the positions of \"leftThigh\", \"leftShin\", \"leftFoot\" and 6 more are near 0, which "
      "would leave no bones: they are added to their OFFSETs\n");
}

TEST(PositionChannels, addToOffsetsBesideZeros) {
  // Most joints of such files never move against their parents.
  const auto shift = [&](std::size_t joint, std::size_t) {
    return joint == 2 ? Vec3(0, -1, 0) : Vec3(0, 0, 0);
  };
  const BvhDocument document = interpreted(walkWith(shift));
  EXPECT_TRUE(document.skeleton.joints[2].offset.isApprox(Vec3(0, -0.46, 0), 1e-9));
  EXPECT_TRUE(document.skeleton.joints[6].offset.isApprox(Vec3(0, -0.45, 0), 1e-9));
  EXPECT_EQ(document.warnings.size(), 2U);
}

TEST(PositionChannels, replaceOffsetsOfABodyOfAnotherSize) {
  // OFFSETs in millimetres, positions in centimetres: a whole body, a tenth as large.
  ParsedBvh parsed = walkWith([](std::size_t joint, std::size_t) { return offsetOf(joint); });
  for (BvhJoint& joint : parsed.hierarchy.joints) {
    if (!joint.isEndSite) joint.offset *= 10.0;
  }
  const BvhDocument document = interpreted(parsed);
  EXPECT_EQ(differenceFromWalker(document), "");
  EXPECT_EQ(warningsOf(document), "");
}

TEST(PositionChannels, leaveOffsetsInForceWhereManyHoldTheSameNumbers) {
  const BvhDocument constant =
      interpreted(walkWith([](std::size_t, std::size_t) { return Vec3(3, 87.2, 440); }));
  EXPECT_EQ(differenceFromWalker(constant), "");
  EXPECT_EQ(
      warningsOf(constant),
      "body.bvh: the position channels of \"leftThigh\", \"leftShin\", \"leftFoot\" and 6 more hold the "
      "same numbers, which cannot be bones: their OFFSETs stay in force\n");
  const Clip clip = testing::walkOf({.frames = 30});
  const BvhDocument ofTheRoot = interpreted(
      walkWith([&](std::size_t, std::size_t frame) { return Vec3(clip.rootPositions[frame] * 100.0); }));
  EXPECT_EQ(differenceFromWalker(ofTheRoot), "");
}

TEST(PositionChannels, replaceEqualOffsetsByEqualNumbers) {
  // Fingers of a hand may all be as long.
  ParsedBvh parsed;
  parsed.addJoint("hand", {}, Vec3::Zero(), kSixChannels);
  for (const char* name : {"a", "b", "c", "d"}) parsed.addJoint(name, 0, Vec3(0, 0, 4), kSixChannels);
  parsed.setFrames(2);
  for (std::size_t f = 0; f < 2; ++f) {
    for (std::size_t j = 1; j < 5; ++j) parsed.place(j, f, Vec3(0, 0.1, 4), Quat::Identity());
  }
  const BvhDocument document = interpreted(parsed);
  EXPECT_EQ(warningsOf(document), "");
  EXPECT_TRUE(document.skeleton.joints[4].offset.isApprox(Vec3(0, 0.001, 0.04), 1e-12));
}

}  // namespace
}  // namespace stridegraph
