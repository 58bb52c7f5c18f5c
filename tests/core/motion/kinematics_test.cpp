#include "motion/kinematics.h"

#include <gtest/gtest.h>

#include "math/rotation.h"
#include "motion/test_characters.h"

namespace stridegraph {
namespace {

using testing::oneLeg;
using testing::restPose;

TEST(JointPositions, addUpOffsetsInTheRestPose) {
  const std::vector<Vec3> positions = jointPositions(oneLeg(), restPose(oneLeg(), {1, 1, 2}).view());
  EXPECT_TRUE(positions[1].isApprox(Vec3(1, 0.5, 2)));
  EXPECT_TRUE(positions[3].isApprox(Vec3(1, 0, 2.2)));
}

TEST(JointPositions, followAKneeBentByNinetyDegrees) {
  Pose pose = restPose(oneLeg(), {0, 1, 0});
  pose.rotations[1] = axisRotation(Axis::kX, Angle::degrees(90));
  const std::vector<Vec3> positions = jointPositions(oneLeg(), pose.view());
  EXPECT_TRUE(positions[2].isApprox(Vec3(0, 0.5, -0.5), 1e-12));
  EXPECT_TRUE(positions[3].isApprox(Vec3(0, 0.3, -0.5), 1e-12));
}

TEST(JointPositions, turnWithTheRoot) {
  Pose pose = restPose(oneLeg(), {0, 1, 0});
  pose.rotations[0] = axisRotation(Axis::kY, Angle::degrees(90));
  EXPECT_TRUE(jointPositions(oneLeg(), pose.view())[3].isApprox(Vec3(0.2, 0, 0), 1e-12));
}

}  // namespace
}  // namespace stridegraph
