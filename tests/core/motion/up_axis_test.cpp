#include "motion/up_axis.h"

#include <gtest/gtest.h>

#include <numeric>

#include "motion/bvh_reader.h"
#include "motion/test_motions.h"

namespace stridegraph {
namespace {

/// What a body tells whose joints have no telling names and that does not move.
BodyEvidence shaped(const Vec3& posed, const Vec3& rest) {
  BodyEvidence evidence;
  evidence.extents = {posed, rest};
  evidence.size = std::max(posed.maxCoeff(), rest.maxCoeff());
  return evidence;
}

std::string messageOf(const BodyEvidence& evidence) {
  Warnings warnings;
  (void)inferUpAxis(evidence, warnings);
  if (warnings.empty()) return {};
  EXPECT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].topic, WarningTopic::kUpAxis);
  return warnings[0].message;
}

UpGuess guessOf(const BodyEvidence& evidence) {
  Warnings warnings;
  return inferUpAxis(evidence, warnings);
}

/// The clip of the walker, turned as a whole; its topmost joint has a name.
BodyEvidence turnedWalk(const Quat& turn, std::string_view topmost = "chest") {
  Skeleton skeleton = testing::walker();
  skeleton.joints[9].name = topmost;
  Clip clip = testing::walkOf({.frames = 60});
  for (Joint& joint : skeleton.joints) joint.offset = turn * joint.offset;
  for (Vec3& position : clip.rootPositions) position = turn * position;
  for (Quat& rotation : clip.rotations) rotation = turn * rotation * turn.conjugate();
  return gatherEvidence(skeleton, clip);
}

const Quat kZUp = axisRotation(Axis::kX, Angle::degrees(90));

TEST(InferUpAxis, isSureOfABodyThatStandsPosedAndAtRest) {
  const BodyEvidence standing = shaped(Vec3(60, 170, 40), Vec3(170, 175, 30));
  EXPECT_EQ(guessOf(standing).up, UpAxis::kY);
  EXPECT_GE(guessOf(standing).confidence, kDoubtfulConfidence);
  EXPECT_EQ(messageOf(standing), "");
  const BodyEvidence zUp = shaped(Vec3(60, 50, 170), Vec3(170, 30, 175));
  EXPECT_EQ(guessOf(zUp).up, UpAxis::kZ);
  EXPECT_EQ(messageOf(zUp), "z is understood as up: the body reaches 170 units along z and 50 along y");
}

TEST(InferUpAxis, followsThePosedBodyWithDoubtWhereTheRestPoseDisagrees) {
  const BodyEvidence evidence = shaped(Vec3(60, 170, 40), Vec3(20, 30, 170));
  EXPECT_EQ(guessOf(evidence).up, UpAxis::kY);
  EXPECT_LT(guessOf(evidence).confidence, kDoubtfulConfidence);
  EXPECT_EQ(messageOf(evidence),
            "y is taken as up, which is doubtful: the body reaches 170 units along y and 40 along z. If it "
            "lies on its side, choose z as the up axis (--up z)");
  EXPECT_EQ(guessOf(shaped(Vec3(60, 50, 170), Vec3(20, 170, 30))).up, UpAxis::kZ);
}

TEST(InferUpAxis, asksTheRestPoseWhereTheMotionLeavesItOpen) {
  EXPECT_EQ(guessOf(shaped(Vec3(60, 100, 100), Vec3(20, 30, 170))).up, UpAxis::kZ);
  EXPECT_EQ(guessOf(shaped(Vec3(60, 100, 100), Vec3(20, 170, 30))).up, UpAxis::kY);
}

TEST(InferUpAxis, isInDoubtWithoutABody) {
  const UpGuess guess = guessOf(BodyEvidence{});
  EXPECT_EQ(guess.up, UpAxis::kY);
  EXPECT_LT(guess.confidence, kDoubtfulConfidence);
}

TEST(InferUpAxis, isSureOfAWalk) {
  EXPECT_EQ(guessOf(turnedWalk(Quat::Identity())).up, UpAxis::kY);
  EXPECT_GT(guessOf(turnedWalk(Quat::Identity())).confidence, 0.95);
  EXPECT_EQ(guessOf(turnedWalk(kZUp)).up, UpAxis::kZ);
  EXPECT_GT(guessOf(turnedWalk(kZUp)).confidence, 0.95);
}

TEST(InferUpAxis, trustsTravelMoreThanTheShapeOfABodyThatCrawls) {
  // The body reaches along z, along which it travels, too.
  BodyEvidence crawling = shaped(Vec3(40, 60, 150), Vec3(60, 170, 40));
  crawling.rootRange = Vec3(20, 10, 400);
  EXPECT_EQ(guessOf(crawling).up, UpAxis::kY);
  EXPECT_GE(guessOf(crawling).confidence, kDoubtfulConfidence);
}

TEST(InferUpAxis, saysWhereTheBodyStandsAlongNeitherYNorZ) {
  const auto expectStandsAlong = [](const Quat& turn, std::string_view direction) {
    EXPECT_NE(messageOf(turnedWalk(turn, "head"))
                  .find(" is taken as up, but the body seems to stand along " + std::string(direction) +
                        ", and only y or z up can be read: turn it where it was exported"),
              std::string::npos)
        << direction << ": " << messageOf(turnedWalk(turn, "head"));
    EXPECT_LT(guessOf(turnedWalk(turn, "head")).confidence, kDoubtfulConfidence);
  };
  expectStandsAlong(axisRotation(Axis::kZ, Angle::degrees(-90)), "x");
  expectStandsAlong(axisRotation(Axis::kX, Angle::degrees(180)), "-y");
  expectStandsAlong(axisRotation(Axis::kX, Angle::degrees(-90)), "-z");
}

TEST(UpLikelihoods, addToOne) {
  for (const BodyEvidence& evidence :
       {BodyEvidence{}, turnedWalk(kZUp), shaped(Vec3(0, 0, 0), Vec3(1, 1, 1))}) {
    const auto likelihoods = upLikelihoods(evidence);
    EXPECT_NEAR(std::accumulate(likelihoods.begin(), likelihoods.end(), 0.0), 1.0, 1e-12);
  }
}

}  // namespace
}  // namespace stridegraph
