#include "motion/bvh_channels.h"

#include <gtest/gtest.h>

#include <vector>

#include "math/rotation.h"

namespace stridegraph {
namespace {

BvhJoint jointWith(std::vector<BvhChannel> channels) {
  BvhJoint joint;
  joint.channels = std::move(channels);
  joint.firstColumn = 1;
  return joint;
}

TEST(BvhChannels, areTakenFromTheJointsPartOfARow) {
  const BvhJoint joint = jointWith({BvhChannel::kZPosition, BvhChannel::kYRotation, BvhChannel::kXPosition});
  const std::vector<double> row = {9, 3, 90, 1, 9};
  EXPECT_EQ(valuesIn(joint, row).size(), 3U);
  EXPECT_EQ(positionIn(joint, row), Vec3(1, 0, 3));
  EXPECT_EQ(alongChannels(joint, Vec3(7, 8, 9)), Vec3(7, 0, 9));
  EXPECT_LT(angleBetween(rotationIn(joint, row), axisRotation(Axis::kY, Angle::degrees(90))).degrees(), 1e-9);
  EXPECT_TRUE(hasPositionChannels(joint));
}

TEST(BvhChannels, turnInTheOrderOfTheFile) {
  const BvhJoint joint = jointWith({BvhChannel::kZRotation, BvhChannel::kXRotation});
  const std::vector<double> row = {9, 40, 50};
  const Quat expected =
      axisRotation(Axis::kZ, Angle::degrees(40)) * axisRotation(Axis::kX, Angle::degrees(50));
  EXPECT_LT(angleBetween(rotationIn(joint, row), expected).degrees(), 1e-9);
  EXPECT_FALSE(hasPositionChannels(joint));
}

TEST(BvhChannels, ofAJointWithoutAnySayNothing) {
  BvhJoint joint;
  const std::vector<double> row = {5};
  EXPECT_TRUE(valuesIn(joint, row).empty());
  EXPECT_EQ(positionIn(joint, row), Vec3(0, 0, 0));
  EXPECT_EQ(rotationIn(joint, row).coeffs(), Quat::Identity().coeffs());
}

}  // namespace
}  // namespace stridegraph
