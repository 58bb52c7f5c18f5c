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
using testing::soleAt;

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

/// By how many degrees the body turns from a frame to the next, to the left.
double degreesTurned(const Clip& clip, std::size_t frame) {
  const Heading now = separateHeading(clip.pose(frame).rotations[0]).heading;
  const Heading next = separateHeading(clip.pose(frame + 1).rotations[0]).heading;
  return (next - now).angle().degrees();
}

double meanSpeed(const Clip& clip, std::size_t first, std::size_t last) {
  double sum = 0.0;
  for (std::size_t f = first; f < last; ++f) sum += rootSpeed(clip, f);
  return sum / static_cast<double>(last - first);
}

/// How far the left foot is to the left of the right one, seen from the body.
double sideways(const Clip& clip, std::size_t frame) {
  const auto joints = jointPositions(gaitSkeleton(), clip.pose(frame));
  const Heading facing = separateHeading(clip.pose(frame).rotations[0]).heading;
  const Vec2 apart =
      onFloor(joints[indexOf(GaitJoint::kLeftFoot)]) - onFloor(joints[indexOf(GaitJoint::kRightFoot)]);
  return apart.dot(facing.rotate({1.0, 0.0}));
}

double degreesInName(const Clip& clip) {
  return std::stod(clip.name.substr(clip.name.find_first_of("0123456789")));
}

struct Arc {
  double radiusMetres = 0.0;
  double speed = 0.0;  ///< m/s
};

/// Of the frames in which the body turns from a quarter to three quarters of the angle in the clip's name.
Arc middleOfTurn(const Clip& clip) {
  double turned = 0.0;
  double metres = 0.0;
  double degrees = 0.0;
  double frames = 0.0;
  for (std::size_t f = 0; f + 1 < clip.frameCount(); ++f) {
    const double step = std::abs(degreesTurned(clip, f));
    turned += step;
    if (turned < 0.25 * degreesInName(clip) || turned > 0.75 * degreesInName(clip)) continue;
    degrees += step;
    metres += rootSpeed(clip, f) / clip.framesPerSecond;
    frames += 1.0;
  }
  return {metres / Angle::degrees(degrees).radians(), metres * clip.framesPerSecond / frames};
}

std::vector<Clip> tightTurns() {
  std::vector<Clip> turns;
  for (Clip& clip : defaultGaitClips())
    if (clip.name.rfind("walk_tight_", 0) == 0) turns.push_back(std::move(clip));
  return turns;
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
  for (const char* kind : {"walk_tight_", "walk_wide_", "turn_on_the_spot_", "start_turned_", "jog_90"}) {
    std::size_t found = 0;
    for (const Clip& clip : defaultGaitClips()) {
      if (clip.name.rfind(kind, 0) != 0) continue;
      const double asked = degreesInName(clip);
      const double side = clip.name.ends_with("_left") ? 1.0 : -1.0;
      EXPECT_NEAR(std::remainder(side * turnedDegrees(clip) - asked, 360.0), 0.0, 20.0) << clip.name;
      ++found;
    }
    EXPECT_GE(found, 2u) << kind;
  }
}

TEST(DefaultGaitClips, neverCrossTheFeetWhenTurningOnTheSpot) {
  const std::vector<Clip> clips = defaultGaitClips();
  for (const char* name : {"turn_on_the_spot_90_left", "turn_on_the_spot_180_right"}) {
    const Clip& clip = named(clips, name);
    for (std::size_t f = 0; f < clip.frameCount(); ++f)
      EXPECT_GT(sideways(clip, f), 0.10) << name << " frame " << f;
  }
}

TEST(DefaultGaitClips, goAroundCornersOnTightArcsAndComeAndLeaveAtAWalk) {
  std::size_t arcs = 0;
  double sum = 0.0;
  for (const Clip& clip : tightTurns()) {
    const std::size_t end = clip.frameCount() - 1;
    EXPECT_NEAR(meanSpeed(clip, 0, 20), 1.15, 0.1) << clip.name;
    EXPECT_NEAR(meanSpeed(clip, end - 20, end), 1.15, 0.1) << clip.name;
    if (degreesInName(clip) < 90.0) continue;
    const Arc arc = middleOfTurn(clip);
    EXPECT_LT(arc.radiusMetres, 0.7) << clip.name;
    EXPECT_NEAR(arc.speed, 0.8, 0.1) << clip.name;
    sum += arc.radiusMetres;
    ++arcs;
  }
  ASSERT_EQ(arcs, 16u);
  EXPECT_LT(sum / static_cast<double>(arcs), 0.5);
}

TEST(DefaultGaitClips, turnTightlyOnTheFootInTheirNameAndHardlyCrossTheFeet) {
  for (const Clip& clip : tightTurns()) {
    for (std::size_t f = 0; f < clip.frameCount(); ++f)
      EXPECT_GT(sideways(clip, f), -0.05) << clip.name << " frame " << f;
    if (clip.name.find("_onto_") != std::string::npos) continue;
    const bool left = clip.name.ends_with("_left");
    const bool inner = clip.name.find("_inner_foot") != std::string::npos;
    const std::size_t middle = clip.frameCount() / 2;
    const double carries = soleAt(clip, middle, left == inner ? Side::kLeft : Side::kRight).toe.y();
    const double swings = soleAt(clip, middle, left == inner ? Side::kRight : Side::kLeft).toe.y();
    EXPECT_LT(carries, kGaitSoleMetres + 0.002) << clip.name;
    EXPECT_GT(swings, kGaitSoleMetres + 0.010) << clip.name;
  }
}

TEST(DefaultGaitClips, haveTurnedBeforeTheyLeaveAStandTurned) {
  const std::vector<Clip> clips = defaultGaitClips();
  for (const int degrees : {45, 90, 135}) {
    const Clip& clip = named(clips, "start_turned_" + std::to_string(degrees) + "_left");
    const std::size_t end = clip.frameCount() - 1;
    std::size_t f = 0;
    for (double turned = 0.0; turned < 0.75 * degrees; ++f) {
      ASSERT_LT(f, end);
      turned += degreesTurned(clip, f);
    }
    EXPECT_LT((onFloor(clip.rootPositions[f]) - onFloor(clip.rootPositions[0])).norm(), 0.2) << degrees;
    EXPECT_NEAR(meanSpeed(clip, end - 20, end), 1.15, 0.1) << degrees;
  }
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
