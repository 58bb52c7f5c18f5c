#include "motion/transition_blend.h"

#include <gtest/gtest.h>

#include "math/rotation.h"
#include "motion/test_motions.h"

namespace stridegraph {
namespace {

using testing::movedOnFloor;
using testing::walker;
using testing::walkOf;
using testing::WalkShape;

/// Largest difference of two poses of the walker: metres of the root, or radians of a joint.
double difference(const PoseView& a, const PoseView& b) {
  double largest = (a.rootPosition - b.rootPosition).norm();
  for (std::size_t j = 0; j < a.rotations.size(); ++j)
    largest = std::max(largest, angleBetween(a.rotations[j], b.rotations[j]).radians());
  return largest;
}

/// The pose without floor point and heading.
Pose withoutPlacement(const PoseView& pose) {
  Pose result{{0, pose.rootPosition.y(), 0}, {pose.rotations.begin(), pose.rotations.end()}};
  result.rotations[0] = separateHeading(pose.rotations[0]).tilt;
  return result;
}

/// How far the root moves sideways, across its heading midway between two frames: metres, largest of all
/// steps.
double largestSideStep(const std::vector<FloorTransform>& track) {
  double largest = 0.0;
  for (std::size_t f = 0; f + 1 < track.size(); ++f) {
    const Heading middle = blend(track[f].heading, track[f + 1].heading, 0.5);
    const Vec2 step = track[f + 1].translation - track[f].translation;
    largest = std::max(largest, std::abs(FloorTransform{{0, 0}, middle}.inverse().heading.rotate(step).x()));
  }
  return largest;
}

Clip turningWalk() {
  return walkOf({.frames = 40, .turnPerSecond = Angle::degrees(90), .phaseCycles = 0.02});
}

TEST(TransitionBlend, ofAClipWithItselfIsTheClip) {
  const Clip clip = turningWalk();
  for (const RootBlend root : {RootBlend::kDifferential, RootBlend::kPlain}) {
    const Clip blended = blendPoses({{&clip, 5, 17}, {&clip, 5, 17}, 13, {BlendEase::kSmooth, root}});
    ASSERT_EQ(blended.frameCount(), 13U);
    for (std::size_t f = 0; f < 13; ++f) EXPECT_LT(difference(blended.pose(f), clip.pose(5 + f)), 1e-7) << f;
  }
}

TEST(TransitionBlend, beginsOnTheSourceAndEndsInTheTargetsPose) {
  const Clip source = walkOf({.frames = 40});
  const Clip target = movedOnFloor(turningWalk(), {{3, -7}, Heading::fromAngle(Angle::degrees(200))});
  for (const BlendEase ease : {BlendEase::kSmooth, BlendEase::kLinear}) {
    const Clip blended =
        blendPoses({{&source, 4, 16}, {&target, 9, 21}, 13, {ease, RootBlend::kDifferential}});
    EXPECT_LT(difference(blended.pose(0), source.pose(4)), 1e-7);
    EXPECT_LT(difference(withoutPlacement(blended.pose(12)).view(), withoutPlacement(target.pose(21)).view()),
              1e-7);
  }
}

TEST(TransitionBlend, doesNotDependOnWhereTheTargetLies) {
  const Clip source = walkOf({.frames = 40});
  const Clip target = turningWalk();
  const Clip moved = movedOnFloor(target, {{3, -7}, Heading::fromAngle(Angle::degrees(200))});
  const Clip here = blendPoses({{&source, 4, 16}, {&target, 9, 21}, 13});
  const Clip there = blendPoses({{&source, 4, 16}, {&moved, 9, 21}, 13});
  for (std::size_t f = 0; f < 13; ++f) EXPECT_LT(difference(here.pose(f), there.pose(f)), 1e-7);
}

TEST(TransitionBlend, stepsLieBetweenThoseOfSourceAndTarget) {
  const Clip slow = walkOf({.frames = 40, .speedMetresPerSecond = 0.9});
  const Clip fast = walkOf({.frames = 40, .speedMetresPerSecond = 1.5});
  const std::vector<FloorTransform> track = blendTrack({{&slow, 0, 12}, {&fast, 0, 12}, 13});
  double before = 0.9 / 30.0;
  for (std::size_t f = 0; f < 12; ++f) {
    const double step = (track[f + 1].translation - track[f].translation).norm();
    EXPECT_GT(step, before - 1e-12);
    EXPECT_LT(step, before + 0.003);
    before = step;
  }
  EXPECT_NEAR(before, 1.5 / 30.0, 0.001);
}

TEST(TransitionBlend, warpsTimeWithoutAChangeOfPaceAtItsEnds) {
  // Both walk steadily, so that the steps tell the pace at which each is played.
  const Clip slow = walkOf({.frames = 40, .speedMetresPerSecond = 0.9});
  const Clip fast = walkOf({.frames = 40, .speedMetresPerSecond = 1.5});
  const std::vector<FloorTransform> track = blendTrack({{&slow, 0, 14}, {&fast, 0, 10}, 13});
  std::vector<double> steps;
  for (std::size_t f = 0; f < 12; ++f)
    steps.push_back(30.0 * (track[f + 1].translation - track[f].translation).norm());
  EXPECT_NEAR(steps.front(), 0.9, 0.04);
  EXPECT_NEAR(steps.back(), 1.5, 0.07);
  for (std::size_t f = 0; f + 1 < 12; ++f) EXPECT_NEAR(steps[f + 1], steps[f], 0.13);
}

TEST(TransitionBlend, progressesAtTheSourcesPaceThenAtTheTargets) {
  const std::size_t spans[][2] = {{12, 12}, {11, 13}, {13, 11}, {10, 14}, {14, 10}, {8, 16}, {3, 90}};
  for (const auto& [source, target] : spans) {
    EXPECT_EQ(blendProgress(source, target, 12, 0), 0.0);
    EXPECT_EQ(blendProgress(source, target, 12, 12), 1.0);
    for (std::size_t step = 0; step < 12; ++step)
      EXPECT_LE(blendProgress(source, target, 12, step), blendProgress(source, target, 12, step + 1));
  }
  // Fine steps, so that a difference is as good as a slope: 1200 of them, 100 to a frame.
  const double first = 1400.0 * blendProgress(1400, 1000, 1200, 1);
  const double last = 1000.0 * (1.0 - blendProgress(1400, 1000, 1200, 1199));
  EXPECT_NEAR(first, 1.0, 2e-3);
  EXPECT_NEAR(last, 1.0, 2e-3);
  EXPECT_NEAR(blendProgress(12, 12, 12, 5), 5.0 / 12.0, 1e-15);
}

TEST(TransitionBlend, smoothEaseBeginsAndEndsMoreSoftlyThanTheLinearOne) {
  const Clip slow = walkOf({.frames = 40, .speedMetresPerSecond = 0.9});
  const Clip fast = walkOf({.frames = 40, .speedMetresPerSecond = 1.5});
  const auto firstChange = [&](BlendEase ease) {
    const auto track = blendTrack({{&slow, 0, 12}, {&fast, 0, 12}, 13, {ease, RootBlend::kDifferential}});
    return (track[1].translation - track[0].translation).norm() - 0.9 / 30.0;
  };
  EXPECT_LT(firstChange(BlendEase::kSmooth), 0.3 * firstChange(BlendEase::kLinear));
}

TEST(TransitionBlend, differentialRootDoesNotSlideSidewaysWhereThePlainOneDoes) {
  const Clip straight = walkOf({.frames = 60});
  const Clip turning = walkOf({.frames = 60, .turnPerSecond = Angle::degrees(90)});
  const auto side = [&](RootBlend root) {
    return largestSideStep(
        blendTrack({{&straight, 0, 40}, {&turning, 0, 40}, 41, {BlendEase::kSmooth, root}}));
  };
  // A step of the turning walk itself lies half a turn of 3 degrees off its middle heading: about 1 mm of 40.
  EXPECT_LT(side(RootBlend::kDifferential), 0.0012);
  EXPECT_GT(side(RootBlend::kPlain), 0.005);
}

TEST(TransitionBlend, turnsHalfAsMuchBetweenStraightAndTurning) {
  const Clip straight = walkOf({.frames = 60});
  const Clip turning = walkOf({.frames = 60, .turnPerSecond = Angle::degrees(90)});
  const std::vector<FloorTransform> track = blendTrack({{&straight, 0, 20}, {&turning, 0, 20}, 21});
  EXPECT_NEAR(track.back().heading.angle().degrees(), 30.0, 0.05);
}

TEST(TransitionBlend, unequalSpansBeginAndEndAtTheirClipsPace) {
  const Clip clip = walkOf({.frames = 60});
  const Clip blended = blendPoses({{&clip, 0, 10}, {&clip, 30, 50}, 16});
  ASSERT_EQ(blended.frameCount(), 16U);
  EXPECT_LT(difference(blended.pose(0), clip.pose(0)), 1e-7);
  EXPECT_LT(difference(withoutPlacement(blended.pose(15)).view(), withoutPlacement(clip.pose(50)).view()),
            1e-7);
  // Both are walked at 4 cm a frame: at the ends that is the pace, between them it hardly sinks.
  const auto step = [&](std::size_t f) {
    return blended.rootPositions[f + 1].z() - blended.rootPositions[f].z();
  };
  EXPECT_NEAR(step(0), 0.04, 0.0015);
  EXPECT_NEAR(step(14), 0.04, 0.0015);
  for (std::size_t f = 0; f < 15; ++f) {
    EXPECT_LT(step(f), 0.0405);
    EXPECT_GT(step(f), 0.034);
  }
}

TEST(TransitionBlend, trackIsWherePosesAre) {
  const Clip source = walkOf({.frames = 40});
  const Clip target = turningWalk();
  const TransitionBlend transition{{&source, 4, 12}, {&target, 9, 25}, 13};
  const Clip poses = blendPoses(transition);
  const std::vector<FloorTransform> track = blendTrack(transition);
  ASSERT_EQ(track.size(), poses.frameCount());
  for (std::size_t f = 0; f < track.size(); ++f) {
    const FloorTransform placement = rootPlacement(poses.pose(f));
    EXPECT_EQ(placement.translation, track[f].translation);
    EXPECT_LT(std::abs((placement.heading - track[f].heading).angle().radians()), 1e-9);
  }
}

TEST(TransitionBlendDeathTest, refusesSpansThatLeaveTheClip) {
  const Clip clip = walkOf({.frames = 20});
  EXPECT_DEATH(blendTrack({{&clip, 10, 20}, {&clip, 0, 10}, 11}), "");
  EXPECT_DEATH(blendTrack({{&clip, 5, 5}, {&clip, 0, 10}, 11}), "");
}

}  // namespace
}  // namespace stridegraph
