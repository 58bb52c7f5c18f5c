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

TEST(JointChains, placeWhatWasAskedForAsTheWholeBodyIsPlaced) {
  Pose pose = restPose(oneLeg(), {0, 1, 0});
  pose.rotations[0] = axisRotation(Axis::kY, Angle::degrees(30));
  pose.rotations[1] = axisRotation(Axis::kX, Angle::degrees(40));
  std::vector<JointPlacement> all(oneLeg().size());
  placeJoints(oneLeg(), pose.view(), all);
  const std::vector<JointIndex> knee = {JointIndex(std::size_t{1})};
  const JointChains upToTheKnee(oneLeg(), knee);
  EXPECT_EQ(upToTheKnee.size(), 2U) << "the root and the knee";
  std::vector<JointPlacement> placed(upToTheKnee.size());
  upToTheKnee.place(pose.view(), placed);
  EXPECT_EQ(placed[upToTheKnee.slotOf(knee[0])].position, all[1].position);
  EXPECT_EQ(placed[upToTheKnee.slotOf(knee[0])].rotation.coeffs(), all[1].rotation.coeffs());
  const std::vector<JointIndex> tip = {JointIndex(std::size_t{3}), JointIndex(std::size_t{3})};
  const JointChains whole(oneLeg(), tip);
  EXPECT_EQ(whole.size(), 4U);
  placed.resize(whole.size());
  whole.place(pose.view(), placed);
  for (std::size_t j = 0; j < all.size(); ++j) EXPECT_EQ(placed[j].position, all[j].position);
}

TEST(JointChainsDeathTest, knowNothingOfOtherJoints) {
  const JointChains onlyTheRoot(oneLeg(), {});
  EXPECT_DEATH(static_cast<void>(onlyTheRoot.slotOf(JointIndex(std::size_t{2}))), "");
}

}  // namespace
}  // namespace stridegraph
