#include "graph/skeleton_comparison.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "math/random.h"
#include "motion/test_motions.h"

namespace stridegraph {
namespace {

using testing::walker;

std::string differenceOf(const Skeleton& found, std::size_t mostJoints = 8) {
  return describe(differencesOf(walker(), found), mostJoints);
}

/// The walker without a joint that has no children.
Skeleton without(std::size_t joint) {
  Skeleton skeleton = walker();
  skeleton.joints.erase(skeleton.joints.begin() + static_cast<std::ptrdiff_t>(joint));
  for (Joint& one : skeleton.joints) {
    if (one.parent && one.parent->value > joint) one.parent = JointIndex(std::size_t{one.parent->value} - 1);
  }
  return skeleton;
}

TEST(SkeletonComparison, findsNothingBetweenEqualSkeletons) {
  EXPECT_TRUE(differencesOf(walker(), walker()).empty());
  EXPECT_EQ(differenceOf(walker()), "");
  Skeleton near = walker();
  near.joints[2].offset.y() += 0.0009;
  EXPECT_TRUE(differencesOf(walker(), near).empty());
}

TEST(SkeletonComparison, namesJointsThatAreMissingAndThoseThatAreMore) {
  EXPECT_EQ(differenceOf(without(12)), "lacks leftHand#end");
  Skeleton more = walker();
  more.joints.push_back({"prop", JointIndex(std::size_t{11}), {0.0, -0.1, 0.0}});
  EXPECT_EQ(differenceOf(more), "also has prop");
  EXPECT_EQ(describe(differencesOf(without(12), walker()), 8), "also has leftHand#end");
}

TEST(SkeletonComparison, namesEveryBoneOfAnotherLengthInCentimetres) {
  Skeleton other = walker();
  other.joints[2].offset = {0.0, -0.43, 0.0};
  other.joints[10].offset = {0.2, 0.05, 0.0};
  EXPECT_EQ(differenceOf(other), "leftArm 20.6 cm, expected 20.0 cm, leftShin 43.0 cm, expected 45.0 cm");
}

TEST(SkeletonComparison, tellsBonesThatPointElsewhereByTheirVectors) {
  Skeleton other = walker();
  other.joints[2].offset = {0.0, 0.0, 0.45};
  EXPECT_EQ(differenceOf(other), "leftShin at (0.0, 0.0, 45.0) cm, expected (0.0, -45.0, 0.0) cm");
}

TEST(SkeletonComparison, tellsAScaleOfAllBonesAtOnce) {
  Skeleton other = walker();
  for (Joint& joint : other.joints) joint.offset *= 2.54;
  EXPECT_EQ(differenceOf(other), "all bones are 2.54 times as long: another unit, or a body of another size");
}

TEST(SkeletonComparison, recognisesJointsOfOtherNamesByTheirPlace) {
  Skeleton other = walker();
  other.joints[1].name = "LThigh";
  EXPECT_EQ(differenceOf(other), "leftThigh is called LThigh");
  for (Joint& joint : other.joints) joint.name = "rig:" + joint.name;
  other.joints[1].name = "rig:leftThigh";
  EXPECT_EQ(differenceOf(other), "the names of 10 joints begin with \"rig:\"");
  EXPECT_EQ(describe(differencesOf(other, walker()), 8),
            "the names of 10 joints lack the beginning \"rig:\"");
}

TEST(SkeletonComparison, namesOtherParents) {
  Skeleton other = walker();
  other.joints[10].parent = JointIndex(std::size_t{0});
  EXPECT_EQ(differenceOf(other), "leftArm hangs on hips, expected chest");
}

TEST(SkeletonComparison, tellsJointsFromEndSites) {
  Skeleton other = walker();
  other.joints[12].isEndSite = false;
  EXPECT_EQ(differenceOf(other), "a joint in one and an end site in the other: leftHand#end");
}

TEST(SkeletonComparison, saysWhereTheOrderChanges) {
  Skeleton other = walker();
  // The right leg before the left one.
  std::rotate(other.joints.begin() + 1, other.joints.begin() + 5, other.joints.begin() + 9);
  for (std::size_t j = 1; j < 9; ++j)
    other.joints[j].parent = JointIndex(j == 1 || j == 5 ? std::size_t{0} : j - 1);
  EXPECT_EQ(differenceOf(other), "its joints come in another order from rightThigh on");
}

TEST(SkeletonComparison, namesSoManyJointsAndCountsTheOthers) {
  Skeleton other = walker();
  for (std::size_t j = 1; j < 8; ++j) other.joints[j].offset.x() += 0.01 * static_cast<double>(j);
  const std::string text = differenceOf(other, 2);
  EXPECT_TRUE(text.ends_with(" and 5 more joints")) << text;
  EXPECT_TRUE(text.starts_with("rightFoot 40.6 cm, expected 40.0 cm, ")) << text;
}

/// Of a walker with one thing changed at random.
Skeleton changed(Random& random) {
  Skeleton skeleton = walker();
  Joint& joint = skeleton.joints[1 + random.below(skeleton.size() - 1)];
  switch (random.below(4)) {
    case 0:
      joint.name += "2";
      break;
    case 1:
      joint.offset += Vec3(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(0.002, 0.1));
      break;
    case 2:
      joint.isEndSite = !joint.isEndSite;
      break;
    default:
      return without(random.below(2) == 0 ? 12 : 4);
  }
  return skeleton;
}

TEST(SkeletonComparison, findsSomethingExactlyWhereSkeletonsDiffer) {
  Random random(5);
  for (int k = 0; k < 200; ++k) {
    const Skeleton a = random.below(3) == 0 ? walker() : changed(random);
    const Skeleton b = random.below(3) == 0 ? walker() : changed(random);
    EXPECT_EQ(differencesOf(a, b).empty(), differenceBetween(a, b).empty()) << k;
    EXPECT_EQ(describe(differencesOf(a, b), 8).empty(), differenceBetween(a, b).empty()) << k;
  }
}

}  // namespace
}  // namespace stridegraph
