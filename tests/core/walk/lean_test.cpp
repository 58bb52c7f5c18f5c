#include "walk/lean.h"

#include <gtest/gtest.h>

#include "walk/foot_cleanup.h"
#include "walk/test_library.h"
#include "walk/test_walker.h"

namespace stridegraph {
namespace {

using namespace testing;

constexpr double kFramesPerSecond = 30.0;

Angle angleOf(const Lean& lean) {
  return angleBetween(lean.turn, Quat::Identity());
}

TEST(BalancingLeans, leanByTheAccelerationsShareOfGravity) {
  const std::vector<Vec2> accelerations(61, Vec2(1.5, 0.0));
  const std::vector<Vec3> roots(61, Vec3(4.0, 0.9, 2.0));
  const std::vector<Lean> leans = balancingLeans(accelerations, roots, kFramesPerSecond);
  const Lean& lean = leans[30];
  EXPECT_NEAR(angleOf(lean).degrees(), Angle::radians(std::atan2(1.5, 9.81)).degrees(), 0.6);
  const Vec3 up = lean.turn * Vec3::UnitY();
  EXPECT_GT(up.x(), 0.1) << "towards the acceleration";
  EXPECT_NEAR(up.z(), 0.0, 1e-12);
  // Half of what a pole of 0.9 m does; what it comes down by grows with the square.
  EXPECT_NEAR((lean.feetMove - Vec3(-0.45 * up.x(), 0.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(lean.rootSinks, 0.25 * 0.9 * (1.0 - up.y()), 1e-12);
}

TEST(BalancingLeans, comeAndGoWithoutAJolt) {
  std::vector<Vec2> accelerations(90, Vec2::Zero());
  for (std::size_t f = 30; f < 60; ++f) accelerations[f] = {0.0, -1.5};
  const std::vector<Vec3> roots(90, Vec3(0.0, 0.9, 0.0));
  const std::vector<Lean> leans = balancingLeans(accelerations, roots, kFramesPerSecond);
  EXPECT_TRUE(leans[10].isUpright());
  EXPECT_TRUE(leans[80].isUpright());
  for (std::size_t f = 1; f < leans.size(); ++f)
    EXPECT_LT(angleBetween(leans[f].turn, leans[f - 1].turn).degrees(), 0.6) << f;
}

/// A walker that stands on the spot as if it went round a curve to its left.
SynthesisedWalk leaningWalk() {
  SynthesisedWalk walk = slidingWalk(15, 61, 0.0);
  std::fill(walk.accelerations.begin(), walk.accelerations.end(), Vec2(1.5, 0.0));
  return walk;
}

TEST(FootCleanup, leansIntoBendsAndKeepsFeetFlatOnTheFloor) {
  const MotionLibrary library = standingLibrary();
  const SynthesisedWalk before = leaningWalk();
  SynthesisedWalk walk = before;
  FootCleanup(library).apply(library, walk);
  const PoseView pose = walk.clip.pose(30);
  const PoseView upright = before.clip.pose(30);
  EXPECT_NEAR(angleBetween(pose.rotations[0], upright.rotations[0]).degrees(), 8.4, 0.5);
  EXPECT_EQ(onFloor(pose.rootPosition), onFloor(upright.rootPosition));
  EXPECT_LT(pose.rootPosition.y(), upright.rootPosition.y());
  for (const std::size_t foot : {kLeftFoot, kRightFoot}) {
    const JointPlacement now = placeJoint(walker(), pose, JointIndex(foot));
    const JointPlacement then = placeJoint(walker(), upright, JointIndex(foot));
    EXPECT_LT(angleBetween(now.rotation, then.rotation).degrees(), 0.1) << "as flat as before";
    EXPECT_NEAR(now.position.y(), then.position.y(), 0.002);
    EXPECT_NEAR(now.position.x() - then.position.x(), -0.0725 * upright.rootPosition.y(), 0.005)
        << "outwards";
  }
}

}  // namespace
}  // namespace stridegraph
