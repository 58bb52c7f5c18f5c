#include <gtest/gtest.h>

#include <functional>

#include "math/rotation.h"
#include "motion/bvh_texts.h"
#include "motion/captures.h"
#include "motion/file_unit.h"
#include "motion/kinematics.h"
#include "motion/resample.h"
#include "motion/up_axis.h"

namespace stridegraph {
namespace {

using testing::captures;

/// A clip with its skeleton, y up.
struct Body {
  Skeleton skeleton;
  Clip clip;
};

/// Guesses counted: all, those that were right, and the same of those that claimed to be sure.
struct Tally {
  std::size_t all = 0;
  std::size_t right = 0;
  std::size_t sure = 0;
  std::size_t rightOfSure = 0;

  void count(bool isRight, double confidence) {
    ++all;
    if (isRight) ++right;
    if (confidence < kDoubtfulConfidence) return;
    ++sure;
    if (isRight) ++rightOfSure;
  }
};

/// The captures at 30 frames a second, read once.
const std::vector<Body>& bodies() {
  static const std::vector<Body> all = [] {
    std::vector<Body> read;
    for (const std::filesystem::path& file : captures()) {
      BvhDocument document = testing::read(testing::contentOf(file));
      read.push_back({std::move(document.skeleton), resample(document.clip, 30.0)});
    }
    return read;
  }();
  return all;
}

Body turned(const Body& body, const Quat& turn) {
  Body result = body;
  for (Joint& joint : result.skeleton.joints) joint.offset = turn * joint.offset;
  for (Vec3& position : result.clip.rootPositions) position = turn * position;
  for (Quat& rotation : result.clip.rotations) rotation = turn * rotation * turn.conjugate();
  return result;
}

Body framesOf(const Body& body, std::size_t first, std::size_t count) {
  Body result{body.skeleton, {body.clip.name, body.clip.framesPerSecond, body.clip.jointCount, {}, {}}};
  for (std::size_t f = first; f < std::min(first + count, body.clip.frameCount()); ++f)
    result.clip.append(body.clip.pose(f));
  return result;
}

Body nameless(const Body& body) {
  Body result = body;
  for (std::size_t j = 0; j < result.skeleton.size(); ++j)
    result.skeleton.joints[j].name = "j" + std::to_string(j);
  return result;
}

/// The body tilted about an axis across its heading, with its root at a share of its height.
Body tilted(const Body& body, Angle tilt, double heightShare, bool travels) {
  Body result = body;
  for (std::size_t f = 0; f < body.clip.frameCount(); ++f) {
    const HeadingAndTilt parts = separateHeading(body.clip.pose(f).rotations[0]);
    result.clip.rotationsOf(f)[0] = parts.heading.rotation() * axisRotation(Axis::kX, tilt) * parts.tilt;
    Vec3& root = result.clip.rootPositions[f];
    root.y() *= heightShare;
    if (!travels) root = Vec3(0.0, root.y(), 0.0);
  }
  return result;
}

/// The root with all branches below it that reach down at rest further than they reach up, or with the
/// others.
Body halfOf(const Body& body, bool isLegs) {
  const std::vector<Vec3> positions = jointPositions(body.skeleton, body.clip.pose(0));
  std::vector<std::size_t> branch(body.skeleton.size(), 0);
  std::vector<double> lowest(body.skeleton.size(), 0.0);
  for (std::size_t j = 1; j < body.skeleton.size(); ++j) {
    const std::size_t parent = body.skeleton.joints[j].parent->value;
    branch[j] = parent == 0 ? j : branch[parent];
    lowest[branch[j]] = std::min(lowest[branch[j]], positions[j].y() - positions[0].y());
  }
  Body half{{}, {body.clip.name, body.clip.framesPerSecond, 0, body.clip.rootPositions, {}}};
  std::vector<std::size_t> kept;
  std::vector<std::size_t> place(body.skeleton.size(), 0);
  for (std::size_t j = 0; j < body.skeleton.size(); ++j) {
    const bool isLeg = lowest[branch[j]] < -0.6;
    if (j > 0 && isLeg != isLegs) continue;
    place[j] = kept.size();
    kept.push_back(j);
    Joint joint = body.skeleton.joints[j];
    if (joint.parent) joint.parent = JointIndex(place[joint.parent->value]);
    half.skeleton.joints.push_back(std::move(joint));
  }
  half.clip.jointCount = kept.size();
  for (std::size_t f = 0; f < body.clip.frameCount(); ++f)
    for (const std::size_t j : kept) half.clip.rotations.push_back(body.clip.pose(f).rotations[j]);
  return half;
}

/// Guesses up for every capture as `vary` leaves it, with y and with z up.
Tally upGuesses(const std::function<Body(const Body&)>& vary) {
  const Quat zUp = axisRotation(Axis::kX, Angle::degrees(90));
  Tally tally;
  for (const Body& body : bodies()) {
    const Body varied = vary(body);
    for (const UpAxis up : {UpAxis::kY, UpAxis::kZ}) {
      const Body file = up == UpAxis::kY ? varied : turned(varied, zUp);
      Warnings warnings;
      const UpGuess guess = inferUpAxis(gatherEvidence(file.skeleton, file.clip), warnings);
      tally.count(guess.up == up, guess.confidence);
    }
  }
  return tally;
}

TEST(CapturedUpAxis, isKnownForSureOfWholeClipsAndOfPartsOfThem) {
  if (captures().empty()) GTEST_SKIP() << testing::kNoCaptures;
  const std::vector<std::pair<const char*, std::function<Body(const Body&)>>> variants = {
      {"whole", [](const Body& b) { return b; }},
      {"nameless", nameless},
      {"one frame", [](const Body& b) { return framesOf(b, b.clip.frameCount() / 2, 1); }},
      {"ten frames", [](const Body& b) { return framesOf(b, b.clip.frameCount() / 3, 10); }},
      {"legs", [](const Body& b) { return halfOf(b, true); }},
      {"upper body", [](const Body& b) { return halfOf(b, false); }},
      {"crawling", [](const Body& b) { return tilted(b, Angle::degrees(80), 0.5, true); }},
  };
  for (const auto& [name, vary] : variants) {
    const Tally tally = upGuesses(vary);
    EXPECT_EQ(tally.right, tally.all) << name;
    EXPECT_EQ(tally.sure, tally.all) << name;
  }
}

TEST(CapturedUpAxis, isInDoubtOfBodiesThatLieStill) {
  if (captures().empty()) GTEST_SKIP() << testing::kNoCaptures;
  const Tally tally = upGuesses([](const Body& b) { return tilted(b, Angle::degrees(-90), 0.2, false); });
  EXPECT_GE(static_cast<double>(tally.rightOfSure), 0.99 * static_cast<double>(tally.sure));
  EXPECT_LT(tally.sure, tally.all);
}

TEST(CapturedUpAxis, isSaidToBeAnotherWhereItIs) {
  if (captures().empty()) GTEST_SKIP() << testing::kNoCaptures;
  for (const Quat& turn :
       {axisRotation(Axis::kZ, Angle::degrees(-90)), axisRotation(Axis::kX, Angle::degrees(180)),
        axisRotation(Axis::kX, Angle::degrees(-90))}) {
    for (const Body& body : bodies()) {
      const Body file = turned(body, turn);
      Warnings warnings;
      const UpGuess guess = inferUpAxis(gatherEvidence(file.skeleton, file.clip), warnings);
      EXPECT_LT(guess.confidence, kDoubtfulConfidence) << body.clip.name;
      ASSERT_EQ(warnings.size(), 1U) << body.clip.name;
      EXPECT_NE(warnings[0].message.find("only y or z up can be read"), std::string::npos) << body.clip.name;
    }
  }
}

UnitGuess unitOf(const Body& body, double unitsPerMetre) {
  BodyEvidence evidence = gatherEvidence(body.skeleton, body.clip);
  for (Vec3* extent : {&evidence.extents.posed, &evidence.extents.rest}) *extent *= unitsPerMetre;
  Warnings warnings;
  return inferUnit(evidence, UpAxis::kY, warnings);
}

TEST(CapturedUnit, isRightInEveryUnitAndSureInThoseThatAreUsual) {
  if (captures().empty()) GTEST_SKIP() << testing::kNoCaptures;
  for (const double perMetre : {1.0, 10.0, 0.45 / 0.0254, 1.0 / 0.0254, 100.0, 1000.0, 1.0 / 0.3048}) {
    for (const Body& body : bodies()) {
      const UnitGuess guess = unitOf(body, perMetre);
      EXPECT_NEAR(guess.perMetre, perMetre, 1e-9) << body.clip.name;
      if (perMetre == 1.0 || perMetre >= 17.0) {
        EXPECT_GE(guess.confidence, kDoubtfulConfidence) << body.clip.name << " " << perMetre;
      }
    }
  }
}

TEST(CapturedUnit, isMostlyInDoubtWhereNoUnitIsRight) {
  if (captures().empty()) GTEST_SKIP() << testing::kNoCaptures;
  Tally tally;
  for (const double factor : {2.54, 39.37}) {
    for (const Body& body : bodies()) tally.count(false, unitOf(body, 100.0 * factor).confidence);
  }
  EXPECT_EQ(tally.sure, 0U);
}

}  // namespace
}  // namespace stridegraph
