#include "gait_fit/retarget.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gait_fit/walker.h"
#include "math/random.h"
#include "math/rotation.h"
#include "motion/kinematics.h"

namespace stridegraph::gait_fit {
namespace {

/// Another actor who moves as the gait body does: larger, with joints whose axes lie anyhow, under other
/// names.
struct Actor {
  Skeleton skeleton = gaitSkeleton();
  std::vector<Quat> axes;  ///< For each joint: old axes from new ones.
  double scale = 1.25;

  Actor() {
    Random random(9);
    for (std::size_t j = 0; j < skeleton.size(); ++j)
      axes.push_back(skeleton.joints[j].isEndSite
                         ? Quat::Identity()
                         : fromRotationVector(
                               Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1))));
    for (std::size_t j = 1; j < skeleton.size(); ++j) {
      Joint& joint = skeleton.joints[j];
      joint.offset = scale * (axes[joint.parent->value].conjugate() * joint.offset);
    }
    for (Joint& joint : skeleton.joints) {
      if (joint.isEndSite || (joint.name[0] != 'l' && joint.name[0] != 'r')) continue;
      joint.name = (joint.name[0] == 'l' ? "Left" : "Right") + joint.name.substr(1);
    }
  }

  Clip dance(const Clip& clip) const {
    Clip result = clip;
    for (std::size_t f = 0; f < clip.frameCount(); ++f) {
      result.rootPositions[f] = scale * clip.rootPositions[f];
      for (std::size_t j = 0; j < skeleton.size(); ++j) {
        if (skeleton.joints[j].isEndSite) continue;
        const auto& parent = skeleton.joints[j].parent;
        const Quat carried = parent ? axes[parent->value].conjugate() : Quat::Identity();
        result.rotationsOf(f)[j] = carried * clip.pose(f).rotations[j] * axes[j];
      }
    }
    return result;
  }
};

Clip straightWalk() {
  return testing::makeWalk({4.0, [](double) { return 1.3; }, [](double) { return 0.0; }}).clip;
}

TEST(OnGaitBody, leavesClipsOfTheGaitBodyAsTheyAre) {
  const Clip clip = straightWalk();
  const auto same = onGaitBody(gaitSkeleton(), std::span(&clip, 1), Gait::kWalk);
  ASSERT_TRUE(same.has_value());
  ASSERT_EQ(same->size(), 1u);
  EXPECT_EQ(same->front().rootPositions, clip.rootPositions);
}

TEST(OnGaitBody, seesTheSameWalkInAnActorOfOtherSizeAxesAndNames) {
  const Clip clip = straightWalk();
  const Actor actor;
  const Clip danced = actor.dance(clip);
  const auto back = onGaitBody(actor.skeleton, std::span(&danced, 1), Gait::kWalk);
  ASSERT_TRUE(back.has_value()) << back.error().message;
  for (std::size_t f = 0; f < clip.frameCount(); f += 5) {
    const auto expected = jointPositions(gaitSkeleton(), clip.pose(f));
    const auto found = jointPositions(gaitSkeleton(), back->front().pose(f));
    for (std::size_t j = 0; j < expected.size(); ++j)
      EXPECT_LT(((found[j] - found[0]) - (expected[j] - expected[0])).norm(), 0.03) << "joint " << j;
  }
}

TEST(OnGaitBody, refusesABodyWithoutPairsOfLimbs) {
  Skeleton snake;
  snake.joints.push_back({"head", {}, Vec3::Zero()});
  for (std::size_t j = 1; j < 6; ++j)
    snake.joints.push_back({"bone" + std::to_string(j), JointIndex(j - 1), Vec3(0, 0.1, 0.2)});
  Clip clip{"snake", 30.0, snake.size(), {}, {}};
  for (int f = 0; f < 30; ++f)
    clip.append(Pose{Vec3(0, 0, 0.05 * f), std::vector<Quat>(snake.size(), Quat::Identity())}.view());
  const auto refused = onGaitBody(snake, std::span(&clip, 1), Gait::kWalk);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::kSkeletonMismatch);
  EXPECT_NE(refused.error().message.find("found no left and right joints"), std::string::npos);
}

TEST(OnGaitBody, refusesABodyWithoutArms) {
  Skeleton legs;
  legs.joints.push_back({"hips", {}, Vec3::Zero()});
  for (const double side : {1.0, -1.0}) {
    const std::string prefix = side > 0 ? "l" : "r";
    const std::size_t first = legs.size();
    legs.joints.push_back({prefix + "hip", JointIndex(std::size_t{0}), Vec3(0.1 * side, 0, 0)});
    legs.joints.push_back({prefix + "knee", JointIndex(first), Vec3(0, -0.4, 0)});
    legs.joints.push_back({prefix + "ankle", JointIndex(first + 1), Vec3(0, -0.4, 0)});
  }
  Clip clip{"legs", 30.0, legs.size(), {}, {}};
  for (int f = 0; f < 30; ++f)
    clip.append(Pose{Vec3(0, 0.8, 0.05 * f), std::vector<Quat>(legs.size(), Quat::Identity())}.view());
  const auto refused = onGaitBody(legs, std::span(&clip, 1), Gait::kWalk);
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().message.find("found no pair of arms"), std::string::npos);
}

TEST(OnGaitBody, refusesABodyThatStaysWhereItIs) {
  const Actor actor;
  Clip clip{"still", 30.0, kGaitJointCount, {}, {}};
  for (int f = 0; f < 30; ++f) clip.append(gaitPose(Gait::kWalk, {}).view());
  const Clip still = actor.dance(clip);
  const auto refused = onGaitBody(actor.skeleton, std::span(&still, 1), Gait::kWalk);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().message, "found nobody who goes anywhere, expected walks or jogs");
}

}  // namespace
}  // namespace stridegraph::gait_fit
