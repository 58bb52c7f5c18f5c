#include "motion/round_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "math/percentile.h"
#include "motion/gait_library.h"
#include "motion/gait_skeleton.h"
#include "motion/kinematics.h"
#include "motion/odd_skeletons.h"
#include "motion/two_arms.h"

namespace stridegraph {
namespace {

/// The default clips one after the other.
const Clip& gaitFrames() {
  static const Clip frames = [] {
    Clip all;
    all.jointCount = kGaitJointCount;
    for (const Clip& clip : defaultGaitClips())
      for (std::size_t f = 0; f < clip.frameCount(); ++f) all.append(clip.pose(f));
    return all;
  }();
  return frames;
}

double lowestOf(const std::vector<Capsule>& capsules) {
  double lowest = 1e9;
  for (const Capsule& capsule : capsules)
    lowest = std::min({lowest, capsule.from.y() - capsule.fromRadius, capsule.to.y() - capsule.toRadius});
  return lowest;
}

double highestOf(const std::vector<Capsule>& capsules) {
  double highest = -1e9;
  for (const Capsule& capsule : capsules)
    highest = std::max({highest, capsule.from.y() + capsule.fromRadius, capsule.to.y() + capsule.toRadius});
  return highest;
}

/// Whether a point is inside some capsule.
bool isInside(const std::vector<Capsule>& capsules, const Vec3& point) {
  return std::any_of(capsules.begin(), capsules.end(), [&](const Capsule& capsule) {
    for (int i = 0; i <= 20; ++i) {
      const double share = i / 20.0;
      const double radius = capsule.fromRadius + (capsule.toRadius - capsule.fromRadius) * share;
      if ((capsule.from + (capsule.to - capsule.from) * share - point).norm() < radius) return true;
    }
    return false;
  });
}

TEST(RoundBody, standsOnTheFloorWithAHeadOnItsShoulders) {
  const Skeleton skeleton = gaitSkeleton();
  const RoundBody body = roundBody(skeleton, gaitFrames());
  const std::vector<Capsule> capsules = placeParts(body, skeleton, body.standing.view());
  EXPECT_NEAR(lowestOf(capsules), 0.0, 0.001);
  const double shoulders =
      jointPositions(skeleton, body.standing.view())[indexOf(GaitJoint::kLeftHumerus)].y();
  EXPECT_GT(highestOf(capsules), shoulders + 0.25);
  EXPECT_LT(highestOf(capsules), shoulders + 0.40);
}

TEST(RoundBody, hasNoGapFromTheSeatToTheCrown) {
  const Skeleton skeleton = gaitSkeleton();
  const RoundBody body = roundBody(skeleton, gaitFrames());
  for (std::size_t f = 0; f < gaitFrames().frameCount(); f += 97) {
    const std::vector<Capsule> capsules = placeParts(body, skeleton, gaitFrames().pose(f));
    const std::vector<Vec3> joints = jointPositions(skeleton, gaitFrames().pose(f));
    const std::array<Vec3, 3> line = {
        joints[indexOf(GaitJoint::kPelvis)],
        0.5 * (joints[indexOf(GaitJoint::kLeftHumerus)] + joints[indexOf(GaitJoint::kRightHumerus)]),
        joints[indexOf(GaitJoint::kHeadEnd)]};
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      for (int k = 0; k <= 20; ++k)
        EXPECT_TRUE(isInside(capsules, line[i] + (line[i + 1] - line[i]) * (k / 20.0)));
  }
}

TEST(RoundBody, touchesTheFloorWithEveryPlantedFoot) {
  const Skeleton skeleton = gaitSkeleton();
  const RoundBody body = roundBody(skeleton, gaitFrames());
  std::size_t planted = 0;
  std::size_t touching = 0;
  for (std::size_t f = 0; f < gaitFrames().frameCount(); ++f) {
    const PoseView pose = gaitFrames().pose(f);
    const std::vector<Vec3> joints = jointPositions(skeleton, pose);
    const double toes =
        std::min(joints[indexOf(GaitJoint::kLeftToesEnd)].y(), joints[indexOf(GaitJoint::kRightToesEnd)].y());
    const double lowest = lowestOf(placeParts(body, skeleton, pose));
    EXPECT_GT(lowest, -0.006);
    if (toes > kGaitSoleMetres + 0.0005) continue;
    ++planted;
    if (std::abs(lowest) <= 0.002) ++touching;
  }
  EXPECT_GT(planted, gaitFrames().frameCount() / 2);
  EXPECT_GT(static_cast<double>(touching), 0.99 * static_cast<double>(planted));
}

TEST(RoundBody, isLiftedToTheFloorWhereTheMotionHasAnother) {
  const Skeleton skeleton = gaitSkeleton();
  EXPECT_EQ(roundBody(skeleton, gaitFrames()).liftMetres, 0.0);
  for (const double level : {-0.9, -0.08, 0.5}) {
    Clip elsewhere = gaitFrames();
    for (Vec3& root : elsewhere.rootPositions) root.y() += level;
    const RoundBody body = roundBody(skeleton, elsewhere);
    EXPECT_NEAR(body.liftMetres, -level, 0.01);
    std::vector<double> lowest;
    for (std::size_t f = 0; f < elsewhere.frameCount(); f += 7)
      lowest.push_back(lowestOf(placeParts(body, skeleton, elsewhere.pose(f))));
    EXPECT_NEAR(percentile(lowest, 0.5), 0.0, 0.002);
  }
}

TEST(RoundBody, isTheSameWhateverTheJointsAreCalled) {
  Skeleton renamed = gaitSkeleton();
  for (Joint& joint : renamed.joints) joint.name = "joint";
  const RoundBody body = roundBody(gaitSkeleton(), gaitFrames());
  const RoundBody same = roundBody(renamed, gaitFrames());
  ASSERT_EQ(body.parts.size(), same.parts.size());
  for (std::size_t i = 0; i < body.parts.size(); ++i) {
    EXPECT_EQ(body.parts[i].from.joint, same.parts[i].from.joint);
    EXPECT_EQ(body.parts[i].to.offset, same.parts[i].to.offset);
    EXPECT_EQ(body.parts[i].to.radius, same.parts[i].to.radius);
  }
}

/// The gait body with a joint between pelvis and hip on either side, as many captures have it.
TEST(RoundBody, findsTheFeetBelowFurtherHipJoints) {
  const Skeleton plain = gaitSkeleton();
  const std::size_t parts = roundBody(plain, gaitFrames()).parts.size();
  Skeleton longer;
  std::vector<std::size_t> placeOf(plain.size());
  Clip frames;
  std::vector<std::size_t> sourceOf;
  for (std::size_t j = 0; j < plain.size(); ++j) {
    Joint joint = plain.joints[j];
    if (joint.parent) joint.parent = JointIndex(placeOf[joint.parent->value]);
    if (j == indexOf(GaitJoint::kLeftFemur) || j == indexOf(GaitJoint::kRightFemur)) {
      Joint hip = joint;
      hip.offset *= 0.3;
      joint.offset *= 0.7;
      longer.joints.push_back(hip);
      sourceOf.push_back(plain.size());
      joint.parent = JointIndex(longer.size() - 1);
    }
    placeOf[j] = longer.size();
    longer.joints.push_back(joint);
    sourceOf.push_back(j);
  }
  frames.jointCount = longer.size();
  for (std::size_t f = 0; f < gaitFrames().frameCount(); f += 50) {
    Pose pose{gaitFrames().rootPositions[f], {}};
    for (const std::size_t source : sourceOf)
      pose.rotations.push_back(source < plain.size() ? gaitFrames().pose(f).rotations[source]
                                                     : Quat::Identity());
    frames.append(pose.view());
  }
  const RoundBody body = roundBody(longer, frames);
  // A bone more on either side.
  EXPECT_EQ(body.parts.size(), parts + 2);
  EXPECT_NEAR(lowestOf(placeParts(body, longer, body.standing.view())), 0.0, 0.002);
}

TEST(RoundBody, isThereForAnySkeleton) {
  for (const Skeleton& skeleton : testing::oddSkeletons()) {
    for (const std::size_t frames : {0U, 1U, 40U}) {
      const RoundBody body = roundBody(skeleton, testing::waving(skeleton, frames, 7));
      EXPECT_FALSE(body.parts.empty());
      EXPECT_EQ(body.standing.rotations.size(), skeleton.size());
      for (const BodyPart& part : body.parts) {
        EXPECT_GT(part.from.radius, 0.0);
        EXPECT_GT(part.to.radius, 0.0);
        EXPECT_FALSE(skeleton.joints[part.from.joint.value].isEndSite);
        EXPECT_FALSE(skeleton.joints[part.to.joint.value].isEndSite);
      }
    }
  }
}

}  // namespace
}  // namespace stridegraph
