#include "motion/file_unit.h"

#include <gtest/gtest.h>

#include "motion/bvh_reader.h"

namespace stridegraph {
namespace {

struct Answer {
  UnitGuess guess;
  std::string message;
};

Answer answerFor(BodyEvidence evidence, UpAxis up = UpAxis::kY) {
  Warnings warnings;
  Answer answer{inferUnit(evidence, up, warnings), {}};
  if (!warnings.empty()) {
    EXPECT_EQ(warnings.size(), 1U);
    EXPECT_EQ(warnings[0].topic, WarningTopic::kUnit);
    answer.message = warnings[0].message;
  }
  return answer;
}

/// A body `height` units tall.
BodyEvidence tall(double height) {
  BodyEvidence evidence;
  evidence.extents.posed = Vec3(0.3 * height, height, 0.2 * height);
  return evidence;
}

TEST(InferUnit, recognisesTheUnitsThatAreInUse) {
  EXPECT_EQ(answerFor(tall(175)).guess.perMetre, 100.0);
  EXPECT_EQ(answerFor(tall(175)).message, "");
  EXPECT_EQ(answerFor(tall(1.7)).guess.perMetre, 1.0);
  EXPECT_EQ(answerFor(tall(1.7)).message,
            "metres are understood as the unit: the body is 1.7 units tall, which is 1.7 m");
  EXPECT_EQ(answerFor(tall(1700)).guess.perMetre, 1000.0);
  EXPECT_NEAR(answerFor(tall(65)).guess.perMetre, 39.3701, 1e-4);
  EXPECT_NEAR(answerFor(tall(25)).guess.perMetre, 17.7165, 1e-4);
  EXPECT_EQ(answerFor(tall(25)).message,
            "CMU units of 5.6444 cm are understood as the unit: the body is 25 units tall, which is 1.41 m");
  EXPECT_NEAR(answerFor(tall(5.4)).guess.perMetre, 3.2808, 1e-4);
  for (const double height : {175.0, 1.7, 1700.0, 65.0, 25.0, 5.4})
    EXPECT_GE(answerFor(tall(height)).guess.confidence, kDoubtfulConfidence) << height;
}

TEST(InferUnit, namesTheOtherUnitWhereItIsInDoubt) {
  const Answer child = answerFor(tall(90));
  EXPECT_EQ(child.guess.perMetre, 100.0);
  EXPECT_LT(child.guess.confidence, kDoubtfulConfidence);
  EXPECT_EQ(
      child.message,
      "centimetres are taken as the unit, which is doubtful: the body is 90 units tall, which is 0.9 m; "
      "in inches it would be 2.29 m. Choose the unit if that is wrong (--units in)");
  EXPECT_LT(answerFor(tall(17)).guess.confidence, kDoubtfulConfidence);
}

TEST(InferUnit, isInDoubtWhereNoUnitMakesAHuman) {
  for (const double height : {0.1, 445.0, 7000.0, 1e9}) {
    EXPECT_LT(answerFor(tall(height)).guess.confidence, kDoubtfulConfidence) << height;
    EXPECT_NE(answerFor(tall(height)).message.find("odd for a human"), std::string::npos) << height;
  }
}

TEST(InferUnit, doesNotKnowTheUnitOfABodyWithoutHeight) {
  const Answer flat = answerFor(tall(0));
  EXPECT_EQ(flat.guess.perMetre, 100.0);
  EXPECT_EQ(flat.guess.confidence, 0.0);
  EXPECT_EQ(flat.message, "centimetres are taken as the unit: the body has no height to tell it from");
}

TEST(InferUnit, trustsTheTallerOfPosesAndRest) {
  BodyEvidence evidence;
  evidence.extents = {Vec3(170, 40, 50), Vec3(150, 170, 30)};
  EXPECT_EQ(answerFor(evidence).guess.perMetre, 100.0);
  EXPECT_EQ(answerFor(evidence).message, "");
}

TEST(InferUnit, measuresAlongTheUpAxis) {
  BodyEvidence evidence;
  evidence.extents.posed = Vec3(1, 100, 1.7);
  EXPECT_EQ(answerFor(evidence, UpAxis::kZ).guess.perMetre, 1.0);
}

TEST(InferUnit, knowsHalfBodiesByTheNamesOfTheirJoints) {
  BodyEvidence upper = tall(75);
  EXPECT_NE(answerFor(upper).guess.perMetre, 100.0);
  upper.hasHead = true;
  EXPECT_EQ(answerFor(upper).guess.perMetre, 100.0);
  BodyEvidence legs = tall(0.9);
  legs.hasFeet = true;
  EXPECT_EQ(answerFor(legs).guess.perMetre, 1.0);
}

}  // namespace
}  // namespace stridegraph
