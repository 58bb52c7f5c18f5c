#include "motion/gait_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "math/random.h"
#include "motion/kinematics.h"

namespace stridegraph {
namespace {

constexpr double kPi = std::numbers::pi;

double largestDistance(const Pose& a, const Pose& b) {
  const auto first = jointPositions(gaitSkeleton(), a.view());
  const auto second = jointPositions(gaitSkeleton(), b.view());
  double largest = 0.0;
  for (std::size_t j = 0; j < first.size(); ++j) largest = std::max(largest, (first[j] - second[j]).norm());
  return largest;
}

GaitState randomState(Random& random) {
  return {random.uniform(0, 2 * kPi), random.uniform(0.9, 1.8), random.uniform(-1.5, 1.5)};
}

TEST(GaitPose, isItsOwnMirrorImageHalfACycleLaterInTheOtherTurn) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const GaitState state = randomState(random);
    const Pose twin = gaitPose(Gait::kWalk, {state.phase + kPi, state.speed, -state.turnRate});
    EXPECT_LT(largestDistance(mirrored(gaitPose(Gait::kWalk, state)), twin), 1e-12);
  }
}

TEST(GaitPose, isItsOwnMirrorImageWhileSpeedAndTurnRateChange) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    GaitState state = randomState(random);
    state.turnAcceleration = random.uniform(-3, 3);
    state.acceleration = random.uniform(-1, 1);
    const Pose pose = gaitPose(gaitTable(Gait::kWalk), state);
    EXPECT_LT(largestDistance(mirrored(pose), gaitPose(Gait::kWalk, mirrored(state))), 1e-12);
  }
}

TEST(GaitRegressors, areThoseOfTheTable) {
  const auto regressors = gaitRegressors(1.3, {0.0, 1.8, 2.0, 3.0, 0.7});
  const std::array<double, kGaitRegressorCount> expected = {1.0, 0.5, 2.0, 4.0, 3.0, 0.7, 6.0, 1.0, 0.25};
  for (std::size_t r = 0; r < expected.size(); ++r) EXPECT_DOUBLE_EQ(regressors[r], expected[r]) << r;
}

TEST(GaitPose, closesAfterACycleAndMovesWithoutJumps) {
  for (const Gait gait : {Gait::kWalk, Gait::kJog}) {
    const double speed = gait == Gait::kWalk ? 1.3 : 2.8;
    EXPECT_LT(largestDistance(gaitPose(gait, {0.3, speed, 0.4}), gaitPose(gait, {0.3 + 2 * kPi, speed, 0.4})),
              1e-12);
    for (int i = 0; i < 360; ++i) {
      const double phase = i * kPi / 180;
      EXPECT_LT(largestDistance(gaitPose(gait, {phase, speed, 0.0}),
                                gaitPose(gait, {phase + kPi / 180, speed, 0.0})),
                0.025);
    }
  }
}

TEST(GaitPose, hasTheLeftFootForemostAtPhaseZero) {
  const auto ahead = [](double phase) {
    const auto p = jointPositions(gaitSkeleton(), gaitPose(Gait::kWalk, {phase, 1.3, 0.0}).view());
    return p[indexOf(GaitJoint::kLeftFoot)].z() - p[indexOf(GaitJoint::kRightFoot)].z();
  };
  EXPECT_GT(ahead(0.0), 0.5);
  EXPECT_GT(ahead(0.0), ahead(0.4));
  EXPECT_GT(ahead(0.0), ahead(-0.4));
  EXPECT_NEAR(ahead(0.0), -ahead(kPi), 1e-12);
}

TEST(GaitPose, leansIntoATurn) {
  const auto sidewaysOfFoot = [](double phase, GaitJoint foot, double turnRate) {
    const auto p = jointPositions(gaitSkeleton(), gaitPose(Gait::kWalk, {phase, 1.3, turnRate}).view());
    return p[indexOf(GaitJoint::kThorax)].x() - p[indexOf(foot)].x();
  };
  const double inTurn = sidewaysOfFoot(0.5 * kPi, GaitJoint::kLeftFoot, 1.0) +
                        sidewaysOfFoot(1.5 * kPi, GaitJoint::kRightFoot, 1.0);
  const double straight = sidewaysOfFoot(0.5 * kPi, GaitJoint::kLeftFoot, 0.0) +
                          sidewaysOfFoot(1.5 * kPi, GaitJoint::kRightFoot, 0.0);
  EXPECT_NEAR(straight, 0.0, 1e-9);
  EXPECT_GT(inTurn, 0.04) << "the trunk lies left of the carrying foot in a left turn";
}

TEST(StandingPose, isSymmetricalAndStandsOnBothFeet) {
  const Pose pose = standingPose();
  EXPECT_LT(largestDistance(pose, mirrored(pose)), 1e-12);
  const auto p = jointPositions(gaitSkeleton(), pose.view());
  EXPECT_NEAR(p[indexOf(GaitJoint::kLeftToesEnd)].y(), kGaitSoleMetres, 0.02);
  EXPECT_GT(p[indexOf(GaitJoint::kHead)].y(), 1.3);
}

TEST(GaitCadence, growsWithSpeedInTheWalk) {
  EXPECT_GT(gaitCadence(Gait::kWalk, 1.6, 0.0), gaitCadence(Gait::kWalk, 1.0, 0.0) + 0.8);
  EXPECT_NEAR(gaitCadence(Gait::kWalk, 1.3, 0.0) / (2 * kPi), 0.92, 0.02) << "strides in a second";
}

TEST(GaitSlip, letsTheHeadingLeadASteadyTurn) {
  EXPECT_LT(gaitSlip(Gait::kWalk, 1.0, 0.0).radians(), 0.0);
  EXPECT_DOUBLE_EQ(gaitSlip(Gait::kWalk, 1.0, 0.5).radians(), -gaitSlip(Gait::kWalk, -1.0, -0.5).radians());
}

TEST(GaitContact, overlapsInTheWalkAndLeavesFlightInTheJog) {
  EXPECT_GT(gaitContact(Gait::kWalk, 1.3).halfWidth(), 0.5 * kPi);
  EXPECT_LT(gaitContact(Gait::kJog, 2.8).halfWidth(), 0.5 * kPi);
}

TEST(GaitContact, changesContinuouslyWithSpeed) {
  for (double speed = 0.6; speed < 2.2; speed += 0.01)
    EXPECT_NEAR(gaitContact(Gait::kWalk, speed).on, gaitContact(Gait::kWalk, speed + 0.01).on, 0.02);
}

TEST(GaitSkeleton, hasEqualSidesAndALayoutForEveryJoint) {
  const Skeleton skeleton = gaitSkeleton();
  ASSERT_EQ(skeleton.size(), kGaitJointCount);
  for (std::size_t j = 0; j < skeleton.size(); ++j) {
    const std::size_t twin = indexOf(otherSide(static_cast<GaitJoint>(j)));
    Vec3 offset = skeleton.joints[j].offset;
    if (twin != j) offset.x() = -offset.x();
    EXPECT_EQ(offset, skeleton.joints[twin].offset);
    EXPECT_EQ(gaitBvhLayout().channels[j].empty(), skeleton.joints[j].isEndSite);
  }
  EXPECT_EQ(skeleton.find("rhand#end"), JointIndex(indexOf(GaitJoint::kRightHandEnd)));
}

}  // namespace
}  // namespace stridegraph
