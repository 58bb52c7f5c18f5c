#include "motion/mirror.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/kinematics.h"
#include "motion/two_arms.h"

namespace stridegraph {
namespace {

using testing::kTwoArmsPartners;
using testing::twoArms;
using testing::waving;

/// The greatest distance between joints of the mirrored clip and the reflection of their partners.
double greatestMirrorError(const Skeleton& skeleton, const MirrorMap& map, const Clip& clip) {
  const Clip other = mirrored(skeleton, map, clip);
  EXPECT_EQ(other.frameCount(), clip.frameCount());
  double greatest = 0.0;
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    const std::vector<Vec3> original = jointPositions(skeleton, clip.pose(f));
    const std::vector<Vec3> reflection = jointPositions(skeleton, other.pose(f));
    for (std::size_t j = 0; j < skeleton.size(); ++j) {
      greatest = std::max(greatest, (reflection[j] - mirrored(original[map.partner[j].value])).norm());
    }
  }
  return greatest;
}

double greatestAngleDegrees(const Clip& a, const Clip& b) {
  double greatest = 0.0;
  for (std::size_t i = 0; i < a.rotations.size(); ++i) {
    greatest = std::max(greatest, angleBetween(a.rotations[i], b.rotations[i]).degrees());
  }
  return greatest;
}

/// The skeleton and clip with the axes of each joint turned arbitrarily: the same motion of the same body.
void turnAxes(Skeleton& skeleton, Clip& clip, std::uint64_t seed) {
  Random random(seed);
  std::vector<Quat> turns;
  for (const Joint& joint : skeleton.joints) {
    const auto part = [&] { return random.uniform(-1.0, 1.0); };
    turns.push_back(joint.isEndSite ? Quat::Identity() : Quat(part(), part(), part(), part()).normalized());
  }
  const std::vector<Joint> joints = skeleton.joints;
  const auto parentTurn = [&](std::size_t j) { return turns[joints[j].parent->value]; };
  for (std::size_t j = 1; j < joints.size(); ++j) {
    skeleton.joints[j].offset = parentTurn(j).conjugate() * joints[j].offset;
  }
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    for (std::size_t j = 0; j < joints.size(); ++j) {
      Quat& rotation = clip.rotationsOf(f)[j];
      if (joints[j].isEndSite) continue;
      rotation = (j == 0 ? Quat::Identity() : parentTurn(j).conjugate()) * rotation * turns[j];
    }
  }
}

TEST(MirroredRotation, reflectsWhatItTurns) {
  const Quat rotation = Quat(0.1, 0.2, -0.3, 0.4).normalized();
  const Vec3 v(1, 2, 3);
  EXPECT_TRUE(mirrored(rotation * v).isApprox(mirrored(rotation) * mirrored(v), 1e-12));
  EXPECT_TRUE(mirrored(axisRotation(Axis::kY, Angle::degrees(30)))
                  .isApprox(axisRotation(Axis::kY, Angle::degrees(-30)), 1e-12));
}

TEST(Mirrored, isTheExactReflectionForASymmetricSkeleton) {
  const Skeleton skeleton = twoArms();
  const Clip clip = waving(skeleton, 50, 1);
  const Result<MirrorMap> map = findMirrorMap(skeleton, {});
  ASSERT_TRUE(map);
  for (std::size_t j = 0; j < skeleton.size(); ++j) {
    EXPECT_EQ(map->partner[j].value, kTwoArmsPartners[j]);
    EXPECT_LT(angleBetween(map->correction[j], Quat::Identity()).degrees(), 1e-5);
  }
  EXPECT_LT(greatestMirrorError(skeleton, *map, clip), 1e-9);
  const Clip other = mirrored(skeleton, *map, clip);
  EXPECT_EQ(other.name, "waving (mirrored)");
  EXPECT_EQ(other.framesPerSecond, clip.framesPerSecond);
  EXPECT_TRUE(other.rootPositions[10].isApprox(Vec3(-1.0, 1.0, 0.3)));
}

TEST(Mirrored, isTheExactReflectionForASkeletonThatFacesX) {
  Skeleton skeleton = twoArms();
  for (Joint& joint : skeleton.joints) {
    joint.name = "joint";
    joint.offset = Vec3(joint.offset.z(), joint.offset.y(), -joint.offset.x());
  }
  const Result<MirrorMap> map = findMirrorMap(skeleton, {});
  ASSERT_TRUE(map);
  EXPECT_LT(greatestMirrorError(skeleton, *map, waving(skeleton, 50, 2)), 1e-9);
}

TEST(Mirrored, isTheReflectionForArbitraryRestAxes) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Skeleton skeleton = twoArms();
    Clip clip = waving(skeleton, 100, seed);
    turnAxes(skeleton, clip, seed + 100);
    const Result<MirrorMap> map = findMirrorMap(skeleton, std::span(&clip, 1));
    ASSERT_TRUE(map);
    EXPECT_LT(greatestMirrorError(skeleton, *map, clip), 1e-4);
  }
}

TEST(Mirrored, twiceIsTheClipAgain) {
  Skeleton skeleton = twoArms();
  Clip clip = waving(skeleton, 40, 5);
  turnAxes(skeleton, clip, 6);
  const Result<MirrorMap> map = findMirrorMap(skeleton, std::span(&clip, 1));
  ASSERT_TRUE(map);
  const Clip twice = mirrored(skeleton, *map, mirrored(skeleton, *map, clip));
  EXPECT_LT(greatestAngleDegrees(clip, twice), 0.01);
  EXPECT_TRUE(twice.rootPositions[7].isApprox(clip.rootPositions[7]));
}

TEST(Mirrored, ofAMotionThatIsItsOwnReflectionIsThatMotionWhateverTheRestAxes) {
  Skeleton skeleton = twoArms();
  const Result<MirrorMap> plain = findMirrorMap(skeleton, {});
  ASSERT_TRUE(plain);
  Clip clip = waving(skeleton, 60, 8);
  const Clip reflection = mirrored(skeleton, *plain, clip);
  for (std::size_t f = 0; f < 60; ++f) clip.append(reflection.pose(f));
  turnAxes(skeleton, clip, 9);
  const Result<MirrorMap> map = findMirrorMap(skeleton, std::span(&clip, 1));
  ASSERT_TRUE(map);
  const Clip other = mirrored(skeleton, *map, clip);
  for (std::size_t f = 0; f < 60; ++f) {
    for (std::size_t j = 0; j < skeleton.size(); ++j) {
      EXPECT_LT(angleBetween(other.pose(f).rotations[j], clip.pose(f + 60).rotations[j]).degrees(), 0.1);
    }
  }
}

TEST(FindMirrorMap, refusesASkeletonWithoutSides) {
  Skeleton skeleton = twoArms();
  for (Joint& joint : skeleton.joints) joint.name = "joint";
  skeleton.joints[3].offset.y() = 0.5;
  const Result<MirrorMap> map = findMirrorMap(skeleton, {});
  ASSERT_FALSE(map);
  EXPECT_EQ(map.error().code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(
      map.error().message,
      "found no left and right joints to mirror, expected names such as LeftArm and RightArm or a rest pose "
      "that is symmetric about x = 0 or z = 0");
}

}  // namespace
}  // namespace stridegraph
