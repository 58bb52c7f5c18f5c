#include "motion/gait_synthesis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "motion/gait_measures.h"
#include "motion/kinematics.h"

namespace stridegraph {
namespace {

using testing::fastestJoint;
using testing::framesWithoutFirmFoot;
using testing::lowestSole;

constexpr double kPi = std::numbers::pi;

GaitRequest straight(double speed, double seconds = 3.0) {
  return {"straight", {{seconds, speed}}};
}

/// Straight, a turn by `degrees` to the left (negative: right), straight.
GaitRequest turn(double degrees, double speed = 1.0, double rate = 1.5) {
  const double angle = degrees * kPi / 180;
  GaitRequest request{
      "turn", {{1.2, speed}, {std::abs(angle) / rate, speed, std::copysign(rate, angle)}, {1.2, speed}}};
  request.startPhase = degrees > 0 ? 0.0 : kPi;
  return request;
}

GaitRequest standWalkStand() {
  GaitRequest request{"stand-walk-stand", {{1.5, 0.0}, {3.0, 1.2}, {1.5, 0.0}}};
  request.startPhase = request.endPhase = 0.5 * kPi;
  return request;
}

GaitRequest spotTurn() {
  GaitRequest request{"spot", {{1.0, 0.0}, {1.5, 0.0, 1.2}, {1.0, 0.0}}};
  request.startPhase = 0.5 * kPi;
  return request;
}

Clip made(const GaitRequest& request) {
  Result<Clip> clip = synthesiseGait(request);
  EXPECT_TRUE(clip.has_value());
  return clip ? *clip : Clip{};
}

std::string refusal(const GaitRequest& request) {
  const Result<Clip> clip = synthesiseGait(request);
  return clip ? "accepted" : clip.error().message;
}

Angle headingAt(const Clip& clip, std::size_t frame) {
  return separateHeading(clip.pose(frame).rotations[0]).heading.angle();
}

TEST(SynthesiseGait, goesAsFastAsAsked) {
  for (const double speed : {0.8, 1.0, 1.3, 1.7}) {
    const Clip clip = made(straight(speed, 4.0));
    ASSERT_EQ(clip.frameCount(), 120u);
    const Vec2 way = onFloor(clip.rootPositions.back()) - onFloor(clip.rootPositions.front());
    EXPECT_NEAR(way.y() / (119.0 / 30.0), speed, 0.03);
    EXPECT_NEAR(way.x(), 0.0, 0.05);
  }
}

TEST(SynthesiseGait, turnsAsFarAsAsked) {
  for (const double degrees : {45.0, 90.0, 135.0, 180.0}) {
    const Clip clip = made(turn(degrees));
    const Vec2 end = onFloor(clip.rootPositions.back()) - onFloor(clip.rootPositions[clip.frameCount() - 20]);
    const Vec2 start = onFloor(clip.rootPositions[19]) - onFloor(clip.rootPositions[0]);
    const Angle turned = (Heading::alongDirection(end) - Heading::alongDirection(start)).angle();
    EXPECT_NEAR(std::remainder(turned.degrees() - degrees, 360.0), 0.0, 8.0);
  }
}

TEST(SynthesiseGait, mirrorsARightTurnFromALeftOne) {
  const Clip left = made(turn(90));
  const Clip right = made(turn(-90));
  ASSERT_EQ(left.frameCount(), right.frameCount());
  for (std::size_t f = 0; f < left.frameCount(); ++f) {
    const PoseView view = left.pose(f);
    const Pose twin = mirrored({view.rootPosition, {view.rotations.begin(), view.rotations.end()}});
    const auto a = jointPositions(gaitSkeleton(), twin.view());
    const auto b = jointPositions(gaitSkeleton(), right.pose(f));
    for (std::size_t j = 0; j < a.size(); ++j) ASSERT_LT((a[j] - b[j]).norm(), 1e-9) << "frame " << f;
  }
}

TEST(SynthesiseGait, keepsAFootFirmlyOnTheFloorWhileWalking) {
  for (const GaitRequest& request :
       {straight(0.8), straight(1.3), straight(1.7), turn(90), turn(-180), standWalkStand(), spotTurn()}) {
    const Clip clip = made(request);
    EXPECT_LE(framesWithoutFirmFoot(clip), clip.frameCount() / 25) << request.name;
    EXPECT_GT(lowestSole(clip), kGaitSoleMetres - 0.002) << request.name;
  }
}

TEST(SynthesiseGait, keepsBonesAndRotationsWhole) {
  const Clip clip = made(turn(135));
  for (const Quat& rotation : clip.rotations) EXPECT_NEAR(rotation.norm(), 1.0, 1e-12);
}

TEST(SynthesiseGait, movesNoJointFasterThanACapturedBodyDoes) {
  for (const GaitRequest& request : {straight(1.0), straight(1.7), turn(90), standWalkStand(), spotTurn()})
    EXPECT_LT(fastestJoint(made(request)), 12.0) << request.name << ", rad/s";
}

TEST(SynthesiseGait, beginsAndEndsStandingStillWhenAsked) {
  const Clip clip = made(standWalkStand());
  const auto stillAt = [&clip](std::size_t frame) {
    return (clip.rootPositions[frame + 1] - clip.rootPositions[frame]).norm() * clip.framesPerSecond;
  };
  for (std::size_t f = 0; f < 20; ++f) {
    EXPECT_LT(stillAt(f), 0.03);
    EXPECT_LT(stillAt(clip.frameCount() - 2 - f), 0.03);
  }
  const auto first = jointPositions(gaitSkeleton(), clip.pose(0));
  const double apart = first[indexOf(GaitJoint::kLeftFoot)].z() - first[indexOf(GaitJoint::kRightFoot)].z();
  EXPECT_NEAR(apart, 0.0, 0.03) << "feet side by side";
}

TEST(SynthesiseGait, turnsOnTheSpotWithoutLeavingIt) {
  const Clip clip = made(spotTurn());
  for (const Vec3& root : clip.rootPositions) EXPECT_LT(onFloor(root).norm(), 0.09);
  EXPECT_NEAR(headingAt(clip, clip.frameCount() - 1).degrees(), 1.8 * 180 / kPi, 3.0);
}

TEST(SynthesiseGait, goesOverFromWalkToJogWithoutAJump) {
  const Clip clip = made({"bridge", {{2.0, 1.5}, {2.0, 2.6, 0.0, Gait::kJog}}});
  EXPECT_LT(fastestJoint(clip), 16.0);
  for (std::size_t f = 0; f + 1 < clip.frameCount(); ++f)
    EXPECT_LT((clip.rootPositions[f + 1] - clip.rootPositions[f]).norm(), 0.12);
}

TEST(SynthesiseGait, refusesWhatTheModelCannotDoAndSaysWhy) {
  EXPECT_EQ(refusal({"nothing", {}}), "a gait request has no segments (at least one expected)");
  EXPECT_EQ(refusal(straight(2.6)), "speed of segment 0 is 2.6 (0 to 2.3 expected)");
  EXPECT_EQ(refusal({"slow jog", {{1.0, 1.3}, {1.0, 1.0, 0.0, Gait::kJog}}}),
            "speed of segment 1 is 1 (1.6 to 3.4 expected)");
  EXPECT_EQ(refusal({"spin", {{1.0, 1.0, 4.0}}}), "turnRate of segment 0 is 4 (-2.5 to 2.5 expected)");
  EXPECT_EQ(refusal({"no time", {{-1.0, 1.0}}}), "seconds of segment 0 is -1 (0.001 to 60 expected)");
  GaitRequest request = straight(1.0);
  request.framesPerSecond = 0.0;
  EXPECT_EQ(refusal(request), "framesPerSecond is 0 (10 to 240 expected)");
  request = straight(1.0);
  request.variation = 2.5;
  EXPECT_EQ(refusal(request), "variation is 2.5 (0 to 2 expected)");
}

}  // namespace
}  // namespace stridegraph
