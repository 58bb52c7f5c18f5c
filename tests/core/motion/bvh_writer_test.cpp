#include "motion/bvh_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "math/random.h"
#include "motion/bvh_texts.h"

namespace stridegraph {
namespace {

using testing::greatestAngleDegrees;
using testing::greatestDistance;
using testing::kBodyText;
using testing::read;
using testing::replaced;

std::string write(const BvhDocument& document) {
  return writeBvh(document.skeleton, document.layout, document.clip);
}

/// What comes back from writing the document, read as its own layout says.
BvhDocument writtenAndRead(const BvhDocument& document) {
  return read(write(document), {document.layout.unitsPerMetre, document.layout.up});
}

void expectSameMotion(const BvhDocument& document, const BvhDocument& back) {
  EXPECT_EQ(differenceBetween(document.skeleton, back.skeleton, 1e-4), "");
  EXPECT_EQ(document.clip.framesPerSecond, back.clip.framesPerSecond);
  EXPECT_LT(greatestDistance(document, back), 1e-4);
  EXPECT_LT(greatestAngleDegrees(document.clip, back.clip), 0.01);
}

Quat anyRotation(Random& random) {
  const auto part = [&] { return random.uniform(-1.0, 1.0); };
  return Quat(part(), part(), part(), part()).normalized();
}

TEST(WriteBvh, writesTheTextOfTheLayout) {
  const BvhDocument body = read(kBodyText);
  constexpr std::string_view kBeginning =
      "HIERARCHY\nROOT hips\n{\n\tOFFSET 0.000000 0.000000 0.000000\n"
      "\tCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n\tJOINT chest\n";
  EXPECT_EQ(write(body).substr(0, kBeginning.size()), kBeginning);
  EXPECT_NE(write(body).find("MOTION\nFrames: 2\nFrame Time: 0.0333333333\n0.000000 90.000000 "),
            std::string::npos);
  EXPECT_EQ(writtenAndRead(body).layout.channels, body.layout.channels);
  expectSameMotion(body, writtenAndRead(body));
}

TEST(WriteBvh, roundTripsAnyRotationsInEveryOrder) {
  Random random(1);
  const std::array<BvhChannel, 3> axes = {BvhChannel::kXRotation, BvhChannel::kYRotation,
                                          BvhChannel::kZRotation};
  for (std::size_t first = 0; first < 3; ++first) {
    for (const std::size_t step : {1U, 2U}) {
      BvhDocument body = read(kBodyText);
      body.layout.channels[1] = {axes[first], axes[(first + step) % 3], axes[(first + 2 * step) % 3]};
      body.clip.rootPositions.assign(200, Vec3(0, 0.9, 0));
      body.clip.rotations.clear();
      for (std::size_t i = 0; i < 200 * body.skeleton.size(); ++i) {
        body.clip.rotations.push_back(body.skeleton.joints[i % body.skeleton.size()].isEndSite
                                          ? Quat::Identity()
                                          : anyRotation(random));
      }
      const BvhDocument back = writtenAndRead(body);
      EXPECT_EQ(back.layout.channels, body.layout.channels);
      expectSameMotion(body, back);
    }
  }
}

TEST(WriteBvh, roundTripsUnitsAxesAndNames) {
  for (const double units : {1.0, 100.0 / 5.6444, 1000.0}) {
    for (const UpAxis up : {UpAxis::kY, UpAxis::kZ}) {
      BvhDocument body = read(replaced(kBodyText, "End Site\n", "End Site my toe\n"));
      body.layout.unitsPerMetre = units;
      body.layout.up = up;
      const BvhDocument back = writtenAndRead(body);
      expectSameMotion(body, back);
      EXPECT_EQ(back.layout.endSiteNames, body.layout.endSiteNames);
      EXPECT_EQ(back.layout.channels, body.layout.channels);
    }
  }
}

/// The body's chest with other channels, turned about x by `frame` times 20 degrees and about z by
/// `zDegrees`.
BvhDocument chestWith(std::vector<BvhChannel> channels, double zDegrees) {
  BvhDocument body = read(kBodyText);
  body.layout.channels[1] = std::move(channels);
  body.clip.rootPositions.assign(40, Vec3(0, 0.9, 0));
  body.clip.rotations.assign(40 * body.skeleton.size(), Quat::Identity());
  for (std::size_t f = 0; f < 40; ++f) {
    body.clip.rotationsOf(f)[1] = axisRotation(Axis::kX, Angle::degrees(20.0 * static_cast<double>(f))) *
                                  axisRotation(Axis::kZ, Angle::degrees(zDegrees));
  }
  return body;
}

TEST(WriteBvh, keepsFewerRotationChannelsWhereTheySuffice) {
  const BvhDocument one = chestWith({BvhChannel::kXRotation}, 0.0);
  EXPECT_EQ(writtenAndRead(one).layout.channels[1], one.layout.channels[1]);
  expectSameMotion(one, writtenAndRead(one));
  const BvhDocument two = chestWith({BvhChannel::kXRotation, BvhChannel::kZRotation}, 120.0);
  EXPECT_EQ(writtenAndRead(two).layout.channels[1], two.layout.channels[1]);
  expectSameMotion(two, writtenAndRead(two));
}

TEST(WriteBvh, addsTheRotationChannelsThatAClipNeeds) {
  for (const std::vector<BvhChannel>& channels :
       {std::vector<BvhChannel>{}, std::vector{BvhChannel::kXRotation},
        std::vector{BvhChannel::kXRotation, BvhChannel::kYRotation}}) {
    const BvhDocument turned = chestWith(channels, 10.0);
    EXPECT_EQ(writtenAndRead(turned).layout.channels[1].size(), 3U);
    expectSameMotion(turned, writtenAndRead(turned));
  }
}

TEST(WriteBvh, writesNothingForAJointWithoutChannelsThatStaysStill) {
  BvhDocument body = read(kBodyText);
  body.layout.channels[1].clear();
  for (std::size_t f = 0; f < 2; ++f) body.clip.rotationsOf(f)[1] = Quat::Identity();
  EXPECT_TRUE(writtenAndRead(body).layout.channels[1].empty());
  expectSameMotion(body, writtenAndRead(body));
}

TEST(WriteBvh, alwaysGivesTheRootSixChannels) {
  BvhDocument body = read(kBodyText);
  body.layout.channels[0] = {BvhChannel::kYRotation, BvhChannel::kYPosition};
  const BvhDocument back = writtenAndRead(body);
  EXPECT_EQ(back.layout.channels[0].size(), 6U);
  expectSameMotion(body, back);
  body.layout.channels[0] = {};
  for (std::size_t f = 0; f < 2; ++f) body.clip.rotationsOf(f)[0] = Quat::Identity();
  EXPECT_EQ(writtenAndRead(body).layout.channels[0].size(), 6U);
}

TEST(WriteBvh, writesOffsetsIntoPositionChannelsBelowTheRoot) {
  BvhDocument body = read(kBodyText);
  body.layout.channels[3].insert(body.layout.channels[3].begin(),
                                 {BvhChannel::kXPosition, BvhChannel::kYPosition, BvhChannel::kZPosition});
  expectSameMotion(body, writtenAndRead(body));
  EXPECT_EQ(writtenAndRead(body).layout.channels[3].size(), 6U);
}

TEST(WriteBvh, letsAnglesGoOnWithoutJumps) {
  const std::string text =
      write(chestWith({BvhChannel::kZRotation, BvhChannel::kXRotation, BvhChannel::kYRotation}, 0.0));
  EXPECT_NE(text.find(" 780.00000 "), std::string::npos);
}

TEST(WriteBvh, makesNamesThatALineCanHold) {
  BvhDocument body = read(kBodyText);
  body.skeleton.joints[0].name = "";
  body.skeleton.joints[1].name = "chest {\n} ";
  body.skeleton.joints[3].name =
      "Stra\xDF"
      "e";
  body.layout.endSiteNames[2] = "\r\n";
  body.layout.endSiteNames[4] = "a{b";
  const BvhDocument back = writtenAndRead(body);
  ASSERT_EQ(back.skeleton.size(), body.skeleton.size());
  EXPECT_EQ(back.skeleton.joints[0].name, "joint");
  EXPECT_EQ(back.skeleton.joints[1].name, "chest ___");
  EXPECT_EQ(back.skeleton.joints[3].name,
            "Stra\xC3\x9F"
            "e");
  EXPECT_EQ(back.layout.endSiteNames[2], "");
  EXPECT_EQ(back.layout.endSiteNames[4], "a_b");
  EXPECT_LT(greatestDistance(body, back), 1e-4);
}

TEST(WriteBvh, keepsRatesThroughReading) {
  for (const double rate : {1.0, 12.0, 24.0, 25.0, 30.0, 60.0, 100.0, 120.0, 240.0, 1000.0}) {
    BvhDocument body = read(kBodyText);
    body.clip.framesPerSecond = rate;
    EXPECT_EQ(writtenAndRead(body).clip.framesPerSecond, rate);
  }
}

TEST(WriteBvh, writesNoMinusBeforeNothing) {
  BvhDocument body = read(kBodyText);
  body.clip.rootPositions.assign(2, Vec3(-1e-9, 0.9, -1e-12));
  for (Quat& rotation : body.clip.rotations) rotation = axisRotation(Axis::kX, Angle::degrees(-1e-7));
  const std::string text = write(body);
  EXPECT_EQ(text.find("-0.00000"), std::string::npos);
  EXPECT_NE(text.find("\n0.000000 90.000000 0.000000 0.00000 "), std::string::npos);
}

TEST(WriteBvh, writesNumbersThatEveryReaderTakes) {
  BvhDocument body = read(kBodyText);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  body.clip.rootPositions = {Vec3(nan, 1e200, -1e200), Vec3(0, 0.9, 0)};
  const std::string text = write(body);
  EXPECT_NE(text.find("\n0.000000 1000000000.000000 -1000000000.000000 "), std::string::npos);
}

TEST(WriteBvh, keepsTenthsOfAMillimetreInAnyUnit) {
  for (const double units : {1e-3, 0.02, 1.0, 39.37, 1e6}) {
    BvhDocument body = read(kBodyText);
    body.layout.unitsPerMetre = units;
    body.clip.rootPositions = {Vec3(0.12345, 0.9, 0), Vec3(0.12355, 0.9, 0)};
    const BvhDocument back = writtenAndRead(body);
    EXPECT_LT(greatestDistance(body, back), 1e-4);
    EXPECT_EQ(differenceBetween(body.skeleton, back.skeleton, 1e-5), "");
  }
}

TEST(StandardBvhLayout, givesTheRootSixChannelsAndOthersThree) {
  BvhDocument body = read(kBodyText);
  const BvhLayout layout = standardBvhLayout(body.skeleton);
  EXPECT_EQ(layout.channels, body.layout.channels);
  EXPECT_EQ(layout.endSiteNames, body.layout.endSiteNames);
  EXPECT_EQ(layout.unitsPerMetre, 100.0);
}

}  // namespace
}  // namespace stridegraph
