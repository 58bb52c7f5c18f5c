#include "motion/mirror_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "motion/mirror_names.h"
#include "motion/two_arms.h"

namespace stridegraph {
namespace {

using testing::kTwoArmsPartners;
using testing::twoArms;

bool suggests(std::string_view name, std::string_view other) {
  const std::vector<std::string> names = mirroredNames(name);
  return std::find(names.begin(), names.end(), other) != names.end();
}

std::vector<std::size_t> indicesOf(const std::vector<JointIndex>& pairs) {
  std::vector<std::size_t> indices;
  for (const JointIndex pair : pairs) indices.push_back(pair.value);
  return indices;
}

TEST(MirroredNames, knowTheMarksThatAreInUse) {
  EXPECT_TRUE(suggests("LeftArm", "RightArm"));
  EXPECT_TRUE(suggests("mixamorig:RightUpLeg", "mixamorig:LeftUpLeg"));
  EXPECT_TRUE(suggests("hand_left", "hand_right"));
  EXPECT_TRUE(suggests("LEFT_HIP", "RIGHT_HIP"));
  EXPECT_TRUE(suggests("lfemur", "rfemur"));
  EXPECT_TRUE(suggests("LThigh", "RThigh"));
  EXPECT_TRUE(suggests("L_Foot", "R_Foot"));
  EXPECT_TRUE(suggests("thigh.L", "thigh.R"));
  EXPECT_TRUE(suggests("foot_r", "foot_l"));
  EXPECT_TRUE(suggests("upperArmR", "upperArmL"));
  EXPECT_TRUE(suggests("Bip01 L Thigh", "Bip01 R Thigh"));
}

TEST(MirroredNames, leaveLettersInsideWordsAlone) {
  EXPECT_TRUE(mirroredNames("spine").empty());
  EXPECT_TRUE(mirroredNames("pelvis").empty());
  EXPECT_FALSE(suggests("hilt", "hirt"));
  EXPECT_FALSE(suggests("tail", "tair"));
}

TEST(PairJointsByName, pairsJointsAndTheirEndSites) {
  EXPECT_EQ(indicesOf(pairJointsByName(twoArms())), kTwoArmsPartners);
}

TEST(PairJointsByName, givesNothingWithoutPairsOrAgainstTheTree) {
  Skeleton skeleton = twoArms();
  for (Joint& joint : skeleton.joints) joint.name = "joint";
  EXPECT_TRUE(pairJointsByName(skeleton).empty());
  Skeleton crossed = twoArms();
  std::swap(crossed.joints[3].name, crossed.joints[5].name);
  EXPECT_TRUE(pairJointsByName(crossed).empty());
}

TEST(PairJointsByRestPose, findsTheSymmetryAboutEitherPlane) {
  Skeleton skeleton = twoArms();
  EXPECT_EQ(indicesOf(pairJointsByRestPose(skeleton, Vec3::UnitX())), kTwoArmsPartners);
  EXPECT_TRUE(pairJointsByRestPose(skeleton, Vec3::UnitZ()).empty());
  for (Joint& joint : skeleton.joints)
    joint.offset = Vec3(-joint.offset.z(), joint.offset.y(), joint.offset.x());
  EXPECT_EQ(indicesOf(pairJointsByRestPose(skeleton, Vec3::UnitZ())), kTwoArmsPartners);
}

TEST(PairJointsByRestPose, refusesWhatIsNotSymmetric) {
  Skeleton skeleton = twoArms();
  skeleton.joints[3].offset.x() += 0.1;
  EXPECT_TRUE(pairJointsByRestPose(skeleton, Vec3::UnitX()).empty());
}

}  // namespace
}  // namespace stridegraph
