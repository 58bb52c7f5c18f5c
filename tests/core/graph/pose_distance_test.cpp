#include "graph/pose_distance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/random.h"
#include "motion/kinematics.h"
#include "motion/test_motions.h"

namespace stridegraph {
namespace {

using testing::movedOnFloor;
using testing::walker;
using testing::walkOf;
using testing::wanderingClip;

FloorTransform randomPlace(Random& random) {
  return {{random.uniform(-9, 9), random.uniform(-9, 9)},
          Heading::fromAngle(Angle::radians(random.uniform(-3, 3)))};
}

double weightOf(const Skeleton& skeleton, std::string_view joint) {
  return distanceWeights(skeleton)[skeleton.find(joint)->value];
}

TEST(DistanceWeights, leaveOutHandsEndSitesAndTips) {
  EXPECT_EQ(weightOf(walker(), "leftShin"), 1.0);
  EXPECT_EQ(weightOf(walker(), "leftArm"), 1.0);
  EXPECT_EQ(weightOf(walker(), "leftHand"), 0.0);
  EXPECT_EQ(weightOf(walker(), "leftFoot#end"), 0.0);
  Skeleton named = walker();
  named.joints[10].name = "LWrist";
  named.joints[11].name = "gripper";
  named.joints[11].isEndSite = false;
  named.joints[3].name = "LeftToe_End";
  EXPECT_EQ(weightOf(named, "LWrist"), 0.0);
  EXPECT_EQ(weightOf(named, "gripper"), 0.0);
  EXPECT_EQ(weightOf(named, "LeftToe_End"), 0.0);
}

TEST(AlignOnFloor, undoesAFloorTransform) {
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    const FloorTransform place = randomPlace(random);
    std::vector<Vec3> points;
    std::vector<Vec3> moved;
    for (int k = 0; k < 6; ++k) {
      points.emplace_back(random.uniform(-1, 1), random.uniform(0, 2), random.uniform(-1, 1));
      moved.push_back(place.apply(points.back()));
    }
    const FloorTransform found = alignOnFloor(points, moved, std::vector<double>(6, 1.0));
    for (int k = 0; k < 6; ++k) EXPECT_LT((found.apply(moved[k]) - points[k]).norm(), 1e-12);
  }
}

TEST(AlignOnFloor, isBetterThanAnyPlaceNearby) {
  Random random(6);
  std::vector<Vec3> a;
  std::vector<Vec3> b;
  std::vector<double> weights;
  for (int k = 0; k < 8; ++k) {
    a.emplace_back(random.uniform(-1, 1), 0, random.uniform(-1, 1));
    b.emplace_back(random.uniform(-1, 1), 0, random.uniform(-1, 1));
    weights.push_back(random.uniform());
  }
  const auto cost = [&](const FloorTransform& transform) {
    double sum = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k)
      sum += weights[k] * (a[k] - transform.apply(b[k])).squaredNorm();
    return sum;
  };
  const FloorTransform best = alignOnFloor(a, b, weights);
  for (int i = 0; i < 200; ++i) {
    const FloorTransform nudge{{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1)},
                               Heading::fromAngle(Angle::radians(random.uniform(-0.1, 0.1)))};
    EXPECT_GT(cost(nudge * best), cost(best));
  }
}

TEST(PoseDistance, isZeroForTheSameWindowAnywhereOnTheFloor) {
  Random random(7);
  const Clip clip = wanderingClip(walker(), 40, 1);
  const Clip moved = movedOnFloor(clip, randomPlace(random));
  EXPECT_LT(poseDistanceMetres(walker(), clip, 20, moved, 20), 1e-7);
}

TEST(PoseDistance, isSymmetricAndUnmovedByFloorTransforms) {
  Random random(8);
  const Clip a = wanderingClip(walker(), 40, 1);
  const Clip b = wanderingClip(walker(), 40, 2);
  for (std::size_t f = 2; f < 38; f += 3) {
    const double distance = poseDistanceMetres(walker(), a, f, b, 39 - f);
    EXPECT_NEAR(poseDistanceMetres(walker(), b, 39 - f, a, f), distance, 1e-12);
    EXPECT_NEAR(poseDistanceMetres(walker(), a, f, movedOnFloor(b, randomPlace(random)), 39 - f), distance,
                1e-9);
  }
}

TEST(PoseDistance, countsMetresPerJoint) {
  const Clip clip = walkOf({.speedMetresPerSecond = 0.0, .cyclesPerSecond = 0.0});
  Clip raised = clip;
  for (Vec3& root : raised.rootPositions) root.y() += 0.05;
  EXPECT_NEAR(poseDistanceMetres(walker(), clip, 10, raised, 10), 0.05, 1e-12);
}

TEST(PoseDistance, seesSpeedThroughItsWindow) {
  const Clip still = walkOf({.speedMetresPerSecond = 0.0, .cyclesPerSecond = 0.0});
  const Clip sliding = walkOf({.speedMetresPerSecond = 1.5, .cyclesPerSecond = 0.0});
  // 5 cm a frame: -10, -5, 0, 5, 10 cm about the middle, sqrt(250 / 5) cm in the mean.
  EXPECT_NEAR(poseDistanceMetres(walker(), still, 10, sliding, 10), std::sqrt(50.0) / 100.0, 1e-9);
}

TEST(PoseDistance, ignoresTheHand) {
  const Clip clip = walkOf({});
  Clip waving = clip;
  for (std::size_t f = 0; f < clip.frameCount(); ++f)
    waving.rotationsOf(f)[11] = axisRotation(Axis::kX, Angle::degrees(90));
  EXPECT_LT(poseDistanceMetres(walker(), clip, 10, waving, 10), 1e-9);
}

}  // namespace
}  // namespace stridegraph
