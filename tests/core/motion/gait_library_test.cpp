#include "motion/gait_library.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "motion/gait_measures.h"
#include "motion/kinematics.h"

namespace stridegraph {
namespace {

using testing::fastestJoint;
using testing::framesWithoutFirmFoot;
using testing::lowestSole;

const Clip& named(const std::vector<Clip>& clips, const std::string& name) {
  for (const Clip& clip : clips)
    if (clip.name == name) return clip;
  ADD_FAILURE() << "no clip " << name;
  return clips.front();
}

bool isJog(const Clip& clip) {
  return clip.name.find("jog") != std::string::npos;
}

double rootSpeed(const Clip& clip, std::size_t frame) {
  return (onFloor(clip.rootPositions[frame + 1]) - onFloor(clip.rootPositions[frame])).norm() *
         clip.framesPerSecond;
}

/// Facing at the end less facing at the beginning, in degrees, -180..180.
double turnedDegrees(const Clip& clip) {
  const Heading first = separateHeading(clip.pose(0).rotations[0]).heading;
  const Heading last = separateHeading(clip.pose(clip.frameCount() - 1).rotations[0]).heading;
  return (last - first).angle().degrees();
}

TEST(DefaultGaitClips, haveNamesOfTheirOwnAndOneSkeletonAndRate) {
  std::set<std::string> names;
  std::size_t frames = 0;
  for (const Clip& clip : defaultGaitClips()) {
    EXPECT_TRUE(names.insert(clip.name).second) << clip.name;
    EXPECT_EQ(clip.jointCount, kGaitJointCount);
    EXPECT_EQ(clip.framesPerSecond, 30.0);
    EXPECT_GT(clip.frameCount(), 60u) << clip.name << ": 30 frames at its ends cannot be reached";
    frames += clip.frameCount();
  }
  EXPECT_GT(frames, 3000u);
  EXPECT_LT(frames, 6500u);
}

TEST(DefaultGaitClips, haveRightSidesThatMirrorTheLeft) {
  const std::vector<Clip> clips = defaultGaitClips();
  std::size_t pairs = 0;
  for (const Clip& left : clips) {
    const std::size_t at = left.name.rfind("_left");
    if (at == std::string::npos) continue;
    const Clip& right = named(clips, left.name.substr(0, at) + "_right");
    ASSERT_EQ(left.frameCount(), right.frameCount());
    for (std::size_t f = 0; f < left.frameCount(); f += 7) {
      const PoseView view = left.pose(f);
      const Pose twin = mirrored({view.rootPosition, {view.rotations.begin(), view.rotations.end()}});
      const auto a = jointPositions(gaitSkeleton(), twin.view());
      const auto b = jointPositions(gaitSkeleton(), right.pose(f));
      for (std::size_t j = 0; j < a.size(); ++j) ASSERT_LT((a[j] - b[j]).norm(), 1e-9) << left.name;
    }
    ++pairs;
  }
  EXPECT_GE(pairs, 14u);
}

TEST(DefaultGaitClips, keepTheirFeetPlantedAndOverTheFloor) {
  for (const Clip& clip : defaultGaitClips()) {
    EXPECT_GT(lowestSole(clip), kGaitSoleMetres - 0.001) << clip.name;
    if (isJog(clip)) continue;
    EXPECT_LE(framesWithoutFirmFoot(clip), clip.frameCount() / 25) << clip.name;
  }
}

TEST(DefaultGaitClips, moveNoJointFasterThanCapturedWalksAndJogsDo) {
  for (const Clip& clip : defaultGaitClips())
    EXPECT_LT(fastestJoint(clip), isJog(clip) ? 17.0 : 12.0) << clip.name;
}

TEST(DefaultGaitClips, turnByTheAngleInTheirName) {
  const std::vector<Clip> clips = defaultGaitClips();
  for (const char* kind : {"walk_tight_", "walk_wide_", "turn_on_the_spot_"})
    for (const int degrees : {45, 90, 135, 180}) {
      if (std::string(kind) == "turn_on_the_spot_" && degrees % 90 != 0) continue;
      const double left = turnedDegrees(named(clips, kind + std::to_string(degrees) + "_left"));
      EXPECT_NEAR(std::remainder(left - degrees, 360.0), 0.0, 20.0) << kind << degrees;
    }
}

TEST(DefaultGaitClips, neverCrossTheFeetWhenTurningOnTheSpot) {
  const std::vector<Clip> clips = defaultGaitClips();
  for (const char* name : {"turn_on_the_spot_90_left", "turn_on_the_spot_180_right"}) {
    const Clip& clip = named(clips, name);
    for (std::size_t f = 0; f < clip.frameCount(); ++f) {
      const auto joints = jointPositions(gaitSkeleton(), clip.pose(f));
      const Heading facing = separateHeading(clip.pose(f).rotations[0]).heading;
      const Vec2 apart =
          onFloor(joints[indexOf(GaitJoint::kLeftFoot)]) - onFloor(joints[indexOf(GaitJoint::kRightFoot)]);
      EXPECT_GT(apart.dot(facing.rotate({1.0, 0.0})), 0.10) << name << " frame " << f;
    }
  }
}

TEST(DefaultGaitClips, turnTightlyEnoughForNarrowRooms) {
  const std::vector<Clip> clips = defaultGaitClips();
  const Clip& turn = named(clips, "walk_tight_180_left");
  double smallest = turn.rootPositions[0].x();
  double largest = smallest;
  for (const Vec3& root : turn.rootPositions) {
    smallest = std::min(smallest, root.x());
    largest = std::max(largest, root.x());
  }
  EXPECT_LT(largest - smallest, 1.5) << "a half circle of 0.6 m and its run-in";
}

TEST(DefaultGaitClips, startFromAndStopToAStand) {
  const std::vector<Clip> clips = defaultGaitClips();
  for (const char* hand : {"left", "right"}) {
    const Clip& start = named(clips, std::string("start_") + hand);
    const Clip& stop = named(clips, std::string("stop_") + hand);
    for (std::size_t f = 0; f < 20; ++f) {
      EXPECT_LT(rootSpeed(start, f), 0.03);
      EXPECT_LT(rootSpeed(stop, stop.frameCount() - 2 - f), 0.03);
    }
    EXPECT_GT(rootSpeed(start, start.frameCount() - 2), 0.8);
    EXPECT_GT(rootSpeed(stop, 0), 0.8);
  }
}

TEST(ThesisGaitPair, hasTheFramesAndTurnsOfTheThesis) {
  const std::vector<Clip> pair = thesisGaitPair();
  ASSERT_EQ(pair.size(), 2u);
  EXPECT_EQ(pair[0].frameCount(), 46u);
  EXPECT_EQ(pair[1].frameCount(), 105u);
  double rightMost = 0.0;
  for (std::size_t f = 0; f < pair[1].frameCount(); ++f) {
    const double turned = (separateHeading(pair[1].pose(f).rotations[0]).heading -
                           separateHeading(pair[1].pose(0).rotations[0]).heading)
                              .angle()
                              .degrees();
    rightMost = std::min(rightMost, turned);
  }
  EXPECT_LT(rightMost, -30.0);
  EXPECT_LT(std::abs(turnedDegrees(pair[1])), 20.0) << "back to where it looked at first";
}

TEST(DefaultGaitClips, areTheSameOnEveryCall) {
  const std::vector<Clip> first = defaultGaitClips();
  const std::vector<Clip> second = defaultGaitClips();
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t c = 0; c < first.size(); ++c) EXPECT_EQ(first[c].rootPositions, second[c].rootPositions);
}

}  // namespace
}  // namespace stridegraph
