#include "motion/bvh_still_part.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/test_motions.h"

namespace stridegraph {
namespace {

/// A reference with a lamp on either side of the skeleton.
BvhStillPart stage() {
  const JointIndex root(std::size_t{0});
  BvhStillPart still;
  still.joints = {
      {{"reference", {}, Vec3(1, 0, 2)}, axisRotation(Axis::kY, Angle::degrees(90)), {}, ""},
      {{"lamp", root, Vec3(0, 2, 0)}, Quat::Identity(), {}, ""},
      {{"lamp#end", JointIndex(std::size_t{1}), Vec3(0, 1, 0), true}, Quat::Identity(), {}, "bulb"},
      {{"mirror", root, Vec3(0, 3, 0)}, Quat::Identity(), {}, ""}};
  still.before = 3;
  still.holder = 0;
  still.rootOffset = Vec3(0, 0.9, 0);
  return still;
}

TEST(StillPart, standsAroundTheSkeletonInTheOrderOfTheFile) {
  const Skeleton walker = testing::walker();
  const Clip clip = testing::walkOf({.frames = 4});
  BvhLayout layout = standardBvhLayout(walker);
  layout.still = stage();
  const WholeBvh whole = withStillPart(walker, layout, clip);
  ASSERT_EQ(whole.skeleton.size(), walker.size() + 4);
  EXPECT_EQ(whole.travelling, JointIndex(std::size_t{3}));
  EXPECT_EQ(whole.skeleton.joints[3].name, "hips");
  EXPECT_EQ(whole.skeleton.joints[3].parent, JointIndex(std::size_t{0}));
  EXPECT_EQ(whole.skeleton.joints[4].parent, JointIndex(std::size_t{3}));
  EXPECT_EQ(whole.skeleton.joints.back().name, "mirror");
  EXPECT_EQ(whole.layout.endSiteNames[2], "bulb");
  EXPECT_EQ(whole.clip.jointCount, whole.skeleton.size());
  EXPECT_EQ(whole.clip.rotations.size(), 4 * whole.skeleton.size());
  for (std::size_t f = 0; f < 4; ++f) {
    const Quat reference = stage().joints[0].rotation;
    const Vec3 world = Vec3(1, 0, 2) + reference * whole.travel[f];
    EXPECT_TRUE(world.isApprox(clip.rootPositions[f], 1e-12));
    EXPECT_LT(angleBetween(reference * whole.clip.pose(f).rotations[3], clip.pose(f).rotations[0]).degrees(),
              1e-6);
  }
}

TEST(StillPart, hasFaultsThatAreNamed) {
  EXPECT_EQ(faultIn(BvhStillPart{}), "");
  EXPECT_EQ(faultIn(stage()), "");
  const auto faultOf = [](auto change) {
    BvhStillPart still = stage();
    change(still);
    return faultIn(still);
  };
  EXPECT_EQ(faultOf([](BvhStillPart& s) { s.joints[1].joint.parent.reset(); }),
            "still joint 1 is the file's root");
  EXPECT_EQ(faultOf([](BvhStillPart& s) { s.joints[0].joint.parent = JointIndex(std::size_t{1}); }),
            "still joint 0 is not the file's root");
  EXPECT_EQ(faultOf([](BvhStillPart& s) { s.joints[1].joint.parent = JointIndex(std::size_t{3}); }),
            "still joint lamp comes before its parent");
  EXPECT_EQ(faultOf([](BvhStillPart& s) { s.joints[3].joint.parent = JointIndex(std::size_t{2}); }),
            "still joint mirror hangs on an end site");
  EXPECT_EQ(faultOf([](BvhStillPart& s) { s.joints[3].rotation.w() = 2.0; }),
            "still joint mirror has no finite offset and rotation");
  EXPECT_EQ(faultOf([](BvhStillPart& s) {
              s.joints[3].channels = {BvhChannel::kXRotation, BvhChannel::kXRotation};
            }),
            "still joint mirror has a channel twice");
  EXPECT_EQ(faultOf([](BvhStillPart& s) { s.joints[0].joint.isEndSite = true; }),
            "a still root that is an end site");
  EXPECT_EQ(faultOf([](BvhStillPart& s) { s.holder = 3; }),
            "a skeleton behind 3 of 4 still joints hangs on still joint 3");
  EXPECT_EQ(faultOf([](BvhStillPart& s) { s.before = 5; }),
            "a skeleton behind 5 of 4 still joints hangs on still joint 0");
  EXPECT_EQ(faultOf([](BvhStillPart& s) { s.holder = 2; }), "a skeleton that hangs on an end site");
  EXPECT_EQ(faultOf([](BvhStillPart& s) { s.rootOffset.x() = INFINITY; }),
            "an offset of the root that is not finite");
  EXPECT_EQ(faultOf([](BvhStillPart& s) {
              s.before = 4;
              s.holder = 1;
            }),
            "a skeleton out of the order of a file");
  EXPECT_EQ(
      faultOf([](BvhStillPart& s) {
        s.joints.push_back({{"late", JointIndex(std::size_t{1}), Vec3::Zero()}, Quat::Identity(), {}, ""});
      }),
      "still joint late is out of the order of a file");
}

}  // namespace
}  // namespace stridegraph
