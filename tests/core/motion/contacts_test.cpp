#include "motion/contacts.h"

#include <gtest/gtest.h>

#include <bit>

#include "motion/test_motions.h"

namespace stridegraph {
namespace {

using testing::oneLeg;
using testing::restPose;
using testing::walker;
using testing::walkOf;

/// The leg standing, frame by frame at these root heights and forward positions.
Clip legAt(const std::vector<Vec3>& roots) {
  Clip clip{.name = "leg", .framesPerSecond = 30.0, .jointCount = 4, .rootPositions = {}, .rotations = {}};
  for (const Vec3& root : roots) clip.append(restPose(oneLeg(), root).view());
  return clip;
}

std::vector<std::vector<double>> levelsOf(const Skeleton& skeleton, const std::vector<Clip>& clips) {
  std::vector<std::vector<double>> levels;
  for (const Clip& clip : clips) levels.push_back(jointLevelsMetres(skeleton, clip));
  return levels;
}

FootJoints ankleAtFloor() {
  return {{JointIndex(std::size_t{2})}, {0.0}};
}

TEST(FindFootJoints, findsAnklesAndToesOfBothFeet) {
  const FootJoints feet = findFootJoints(walker(), levelsOf(walker(), {walkOf({.frames = 90})}));
  std::vector<std::string> names;
  for (const JointIndex joint : feet.joints) names.push_back(walker().joints[joint.value].name);
  EXPECT_EQ(names, (std::vector<std::string>{"leftFoot", "leftFoot#end", "rightFoot", "rightFoot#end"}));
  EXPECT_LT(feet.levelsMetres[1], feet.levelsMetres[0]);
}

TEST(FindFootJoints, takesTheLowestOfEveryFootWhenThereAreTooMany) {
  Skeleton centipede;
  centipede.joints = {{"root", {}, {0, 0, 0}}};
  for (std::size_t leg = 0; leg < 3; ++leg) {
    centipede.joints.push_back({"foot", JointIndex(std::size_t{0}), {0.2 * static_cast<double>(leg), -1, 0}});
    const JointIndex foot(centipede.size() - 1);
    for (std::size_t toe = 0; toe < 4; ++toe)
      centipede.joints.push_back({"toe", foot, {0.01 * static_cast<double>(toe), -0.05, 0.1}});
  }
  Clip clip{.name = {},
            .framesPerSecond = 30.0,
            .jointCount = centipede.size(),
            .rootPositions = {},
            .rotations = {}};
  clip.append(restPose(centipede, {0, 1.05, 0}).view());
  const FootJoints feet = findFootJoints(centipede, levelsOf(centipede, {clip}));
  EXPECT_EQ(feet.joints.size(), kMaxFootJoints);
  std::vector<int> perLeg(3, 0);
  for (const JointIndex joint : feet.joints) ++perLeg[(joint.value - 1) / 5];
  EXPECT_EQ(perLeg, (std::vector<int>{3, 3, 2}));
}

TEST(FindFootJoints, judgesClipsOnDifferentFloorsEachForItself) {
  Clip raised = walkOf({.frames = 90});
  for (Vec3& root : raised.rootPositions) root.y() += 0.5;
  EXPECT_EQ(findFootJoints(walker(), levelsOf(walker(), {walkOf({.frames = 90}), raised})).joints.size(), 4U);
}

TEST(FootContacts, standWhileLowAndSlow) {
  const Clip still = legAt(std::vector<Vec3>(5, Vec3(0, 1.0, 0)));
  EXPECT_EQ(footContacts(oneLeg(), still, ankleAtFloor()), std::vector<std::uint8_t>(5, 1));
}

TEST(FootContacts, doNotStandOnAir) {
  const Clip lifted = legAt(std::vector<Vec3>(5, Vec3(0, 1.1, 0)));
  EXPECT_EQ(footContacts(oneLeg(), lifted, ankleAtFloor()), std::vector<std::uint8_t>(5, 0));
}

TEST(FootContacts, standOnAWarpedFloorToo) {
  // Two seconds on a floor 4 cm higher than the level that was measured elsewhere.
  const Clip onBump = legAt(std::vector<Vec3>(60, Vec3(0, 1.04, 0)));
  EXPECT_EQ(footContacts(oneLeg(), onBump, ankleAtFloor()), std::vector<std::uint8_t>(60, 1));
  EXPECT_EQ(footContacts(oneLeg(), onBump, ankleAtFloor(), {.warpMetres = 0.0}),
            std::vector<std::uint8_t>(60, 0));
}

TEST(FootContacts, endWhenTheFootIsFast) {
  std::vector<Vec3> roots(5, Vec3(0, 1.0, 0));
  for (std::size_t f = 0; f < 5; ++f) roots.emplace_back(0, 1.0, 0.05 * static_cast<double>(f + 1));
  const std::vector<std::uint8_t> contacts = footContacts(oneLeg(), legAt(roots), ankleAtFloor());
  // 5 cm a frame are 1.5 m/s; the central difference at the last still frame sees half of it, which still
  // holds.
  EXPECT_EQ(contacts, (std::vector<std::uint8_t>{1, 1, 1, 1, 1, 0, 0, 0, 0, 0}));
}

TEST(FootContacts, holdBetweenTheTwoThresholdsOnceBegun) {
  std::vector<Vec3> roots;
  for (const double centimetres : {4.0, 3.5, 2.9, 3.5, 4.0, 5.1, 5.0, 0.0})
    roots.emplace_back(0, 1.0 + centimetres / 100.0, 0);
  // The end shows where the floor is; the last step down is too fast to stand.
  EXPECT_EQ(footContacts(oneLeg(), legAt(roots), ankleAtFloor()),
            (std::vector<std::uint8_t>{0, 0, 1, 1, 1, 0, 0, 0}));
}

TEST(FootContacts, numberTheirBitsByFootJoint) {
  // The ankle's level is far below, so only the toe stands.
  const FootJoints feet{{JointIndex(std::size_t{2}), JointIndex(std::size_t{3})}, {-0.5, 0.0}};
  EXPECT_EQ(footContacts(oneLeg(), legAt({{0, 1, 0}}), feet), std::vector<std::uint8_t>{2});
}

TEST(FloorLevel, isWhereTheLowestFootMostlyStands) {
  std::vector<Vec3> roots(100, Vec3(0, 1.02, 0));
  for (std::size_t f = 0; f < 20; ++f) roots[f].y() = 0.8;
  EXPECT_NEAR(floorLevelMetres(oneLeg(), legAt(roots), ankleAtFloor().joints), 0.02, 1e-12);
}

}  // namespace
}  // namespace stridegraph
