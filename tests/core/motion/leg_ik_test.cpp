#include "motion/leg_ik.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/random.h"
#include "math/rotation.h"
#include "motion/test_characters.h"

namespace stridegraph {
namespace {

using testing::oneLeg;
using testing::restPose;

Leg onlyLeg() {
  return {JointIndex(std::size_t{0}), JointIndex(std::size_t{1}), JointIndex(std::size_t{2}), Vec3::UnitX()};
}

/// The leg with the knee bent by `degrees`, hip 1 m above the floor.
Pose bentLeg(double degrees) {
  Pose pose = restPose(oneLeg(), {0, 1, 0});
  pose.rotations[1] = axisRotation(Axis::kX, Angle::degrees(degrees));
  return pose;
}

double solve(Pose& pose, const Vec3& target, double longestShare = 1.0) {
  return solveLeg(oneLeg(), onlyLeg(), {target, Quat::Identity()}, longestShare, pose.rootPosition,
                  pose.rotations);
}

double kneeDegrees(const Pose& pose) {
  const auto p = jointPositions(oneLeg(), pose.view());
  const double cosine = (p[1] - p[0]).normalized().dot((p[2] - p[1]).normalized());
  return Angle::radians(std::acos(cosine)).degrees();
}

Vec3 randomTarget(Random& random) {
  return {random.uniform(-0.3, 0.3), random.uniform(0.1, 0.6), random.uniform(-0.5, 0.5)};
}

TEST(SolveLeg, bendsTheKneeByARightAngleForTheDiagonalOfASquare) {
  Pose pose = bentLeg(30);
  EXPECT_NEAR(solve(pose, {0, 1 - std::sqrt(0.5), 0}), 0.0, 1e-12);
  EXPECT_NEAR(kneeDegrees(pose), 90.0, 1e-9);
  const auto positions = jointPositions(oneLeg(), pose.view());
  EXPECT_TRUE(positions[1].isApprox(Vec3(0, 1 - std::sqrt(0.125), std::sqrt(0.125)), 1e-9));
}

TEST(SolveLeg, bendsAStraightLegAboutTheBendAxis) {
  Pose pose = bentLeg(0);
  EXPECT_NEAR(solve(pose, {0, 0.3, 0}), 0.0, 1e-12);
  EXPECT_GT(jointPositions(oneLeg(), pose.view())[1].z(), 0.3) << "the knee points forward, +z";
}

TEST(SolveLeg, reachesEveryTargetWithinReachAndKeepsTheFootAsAsked) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    Pose pose = bentLeg(random.uniform(5, 90));
    const Vec3 target = randomTarget(random);
    const Quat foot = axisRotation(Axis::kY, Angle::degrees(random.uniform(-60, 60)));
    const double missed =
        solveLeg(oneLeg(), onlyLeg(), {target, foot}, 1.0, pose.rootPosition, pose.rotations);
    const JointPlacement ankle = placeJoint(oneLeg(), pose.view(), JointIndex(std::size_t{2}));
    if ((target - pose.rootPosition).norm() > 1.0) continue;
    EXPECT_NEAR(missed, 0.0, 1e-12);
    EXPECT_NEAR((ankle.position - target).norm(), 0.0, 1e-9);
    EXPECT_NEAR(angleBetween(ankle.rotation, foot).degrees(), 0.0, 1e-5);
  }
}

TEST(SolveLeg, keepsTheKneeInItsPlaneWhenTheTargetLiesInIt) {
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    Pose pose = bentLeg(random.uniform(5, 90));
    solve(pose, {0, random.uniform(0.1, 0.6), random.uniform(-0.4, 0.4)});
    EXPECT_NEAR(jointPositions(oneLeg(), pose.view())[1].x(), 0.0, 1e-9);
  }
}

TEST(SolveLeg, neverGetsLongerThanAllowedAndSaysWhatIsMissing) {
  Pose pose = bentLeg(30);
  EXPECT_NEAR(solve(pose, {0, -0.5, 0}, 0.98), 1.5 - 0.98, 1e-12);
  const auto positions = jointPositions(oneLeg(), pose.view());
  EXPECT_TRUE(positions[2].isApprox(Vec3(0, 0.02, 0), 1e-6)) << "as far as it goes, towards the target";
}

TEST(SolveLeg, movesAsLittleAsItsTargetDoes) {
  Pose before = bentLeg(20);
  solve(before, {0, 0.02, 0.1}, 0.999);
  for (int i = 1; i <= 200; ++i) {
    Pose now = bentLeg(20);
    solve(now, {0, 0.02 - 0.0005 * i, 0.1}, 0.999);
    EXPECT_LT(angleBetween(before.rotations[1], now.rotations[1]).degrees(), 3.0) << "at step " << i;
    EXPECT_LT(angleBetween(before.rotations[0], now.rotations[0]).degrees(), 3.0) << "at step " << i;
    before = now;
  }
}

TEST(PlaceJoint, agreesWithForwardKinematicsOfTheWholeBody) {
  const Pose pose = bentLeg(40);
  const auto all = jointPositions(oneLeg(), pose.view());
  for (std::size_t j = 0; j < all.size(); ++j)
    EXPECT_TRUE(placeJoint(oneLeg(), pose.view(), JointIndex(j)).position.isApprox(all[j], 1e-12));
}

TEST(LegLengths, areThoseOfTheBones) {
  EXPECT_DOUBLE_EQ(legLengths(oneLeg(), onlyLeg()).whole(), 1.0);
}

}  // namespace
}  // namespace stridegraph
