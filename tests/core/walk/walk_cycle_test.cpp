#include "walk/walk_cycle.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "math/rotation.h"
#include "walk/test_gait_library.h"
#include "walk/test_walker.h"

namespace stridegraph {
namespace {

const MotionLibrary& library() {
  return testing::gaitPlanner().library();
}

std::array<WalkFoot, 2> bothFeet(const MotionLibrary& of) {
  const WalkFeet found = findWalkFeet(of);
  return {found.feet.at(0), found.feet.at(1)};
}

TEST(UpperJoints, areThoseThatNoLegHangsOn) {
  const MotionLibrary standing = testing::standingLibrary();
  const std::vector<JointIndex> joints = upperJoints(standing.skeleton, bothFeet(standing));
  ASSERT_FALSE(joints.empty());
  for (const JointIndex joint : joints) {
    EXPECT_GT(joint.value, testing::kRightTip) << "the root and the legs come first in the walker";
    EXPECT_FALSE(standing.skeleton.joints[joint.value].isEndSite);
  }
}

TEST(WalkCycle, isOfTwoStepsStraightOn) {
  const auto feet = bothFeet(library());
  const auto cycle = steadiestCycle(library(), feet, upperJoints(library().skeleton, feet));
  ASSERT_TRUE(cycle.has_value());
  EXPECT_LT(cycle->before, cycle->begin);
  EXPECT_LT(cycle->begin, cycle->middle);
  EXPECT_LT(cycle->middle, cycle->end);
  const double seconds = (cycle->end - cycle->begin) / library().frames.framesPerSecond;
  EXPECT_GT(seconds, 0.7);
  EXPECT_LT(seconds, 1.8);
  const auto at = [](double frame) { return FrameIndex(static_cast<std::size_t>(frame)); };
  const FloorTransform gone =
      library().placementAt(at(cycle->begin)).inverse() * library().placementAt(at(cycle->end));
  EXPECT_GT(gone.translation.y(), 0.5);
  EXPECT_LT(std::abs(gone.translation.x()), 0.2);
}

TEST(WalkCycle, goesRoundWithoutAJump) {
  const auto feet = bothFeet(library());
  const std::vector<JointIndex> joints = upperJoints(library().skeleton, feet);
  const auto cycle = steadiestCycle(library(), feet, joints);
  ASSERT_TRUE(cycle.has_value());
  const std::size_t first = cycle->firstFoot;
  for (const JointIndex joint : joints) {
    const auto shown = [&](std::size_t foot, double share) {
      return rotationInCycle(library(), *cycle, joint, foot, share);
    };
    EXPECT_LT(angleBetween(shown(first, 1.0), shown(1 - first, 0.0)).degrees(), 0.01);
    EXPECT_LT(angleBetween(shown(1 - first, 1.0), shown(first, 0.0)).degrees(), 0.01);
  }
}

TEST(WalkCycle, isNoneWhereNobodyWalks) {
  const MotionLibrary standing = testing::standingLibrary();
  const auto feet = bothFeet(standing);
  EXPECT_FALSE(steadiestCycle(standing, feet, upperJoints(standing.skeleton, feet)).has_value());
  EXPECT_FALSE(steadiestCycle(library(), bothFeet(library()), {}).has_value());
}

}  // namespace
}  // namespace stridegraph
