#include "motion/motion_limits.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "math/random.h"
#include "math/rotation.h"
#include "motion/test_characters.h"

namespace stridegraph {
namespace {

using testing::oneLeg;
using testing::restPose;

constexpr std::size_t kKnee = 1;
constexpr std::size_t kAnkle = 2;

/// The leg, its knee turned about x by these degrees, frame by frame.
Clip withKneeAt(const std::vector<double>& degrees) {
  Clip clip;
  clip.jointCount = oneLeg().size();
  Pose pose = restPose(oneLeg(), {0, 1, 0});
  for (const double angle : degrees) {
    pose.rotations[kKnee] = axisRotation(Axis::kX, Angle::degrees(angle));
    clip.append(pose.view());
  }
  return clip;
}

/// `count` frames in which the knee goes on by 1 degree (30 degrees a second) and once by 4.
std::vector<double> steadyWithOneJump(std::size_t count, std::size_t jumpTo) {
  std::vector<double> degrees;
  double angle = 0.0;
  for (std::size_t f = 0; f < count; ++f) degrees.push_back(angle += f == jumpTo ? 4.0 : 1.0);
  return degrees;
}

TurnRates ratesOf(const Clip& clip) {
  return turnRates(wholeOf(clip), JointIndex(kKnee));
}

MotionLimits limitsOf(const Clip& clip) {
  return motionLimits(std::vector{wholeOf(clip)});
}

TEST(TurnRates, areTheTurnAndItsChangePerSecond) {
  const TurnRates rates = ratesOf(withKneeAt({0, 1, 3}));
  ASSERT_EQ(rates.speeds.size(), 2U);
  ASSERT_EQ(rates.accelerations.size(), 1U);
  EXPECT_NEAR(rates.speeds[0], Angle::degrees(30).radians(), 1e-9);
  EXPECT_NEAR(rates.speeds[1], Angle::degrees(60).radians(), 1e-9);
  EXPECT_NEAR(rates.accelerations[0], Angle::degrees(900).radians(), 1e-7);
}

TEST(TurnRates, doNotSeeTheSignOfAQuaternion) {
  Clip clip = withKneeAt({0, 1, 2});
  Quat& knee = clip.rotationsOf(1)[kKnee];
  knee.coeffs() = -knee.coeffs();
  EXPECT_NEAR(ratesOf(clip).accelerations[0], 0.0, 1e-7);
}

TEST(MotionLimits, areReachedInOneFrameOfAThousand) {
  std::vector<double> degrees = {0.0};
  for (int i = 1; i <= 1000; ++i) degrees.push_back(degrees.back() + 0.02 * i);
  // Speeds are 0.6, 1.2, ... 600 degrees a second; rank 998.001 of 0..999 lies just above the 999th.
  EXPECT_NEAR(limitsOf(withKneeAt(degrees)).speeds[kKnee], Angle::degrees(599.4006).radians(), 1e-6);
}

TEST(MotionLimits, areNotSetByASingleJump) {
  const MotionLimits limits = limitsOf(withKneeAt(steadyWithOneJump(5000, 2000)));
  EXPECT_NEAR(limits.speeds[kKnee], Angle::degrees(30).radians(), 1e-9);
}

TEST(MotionLimits, leaveStillJointsTheNoiseOfCapture) {
  const MotionLimits limits = limitsOf(withKneeAt({0, 1, 2}));
  EXPECT_EQ(limits.speeds[kAnkle], 0.5);
  EXPECT_EQ(limits.accelerations[kAnkle], 15.0);
}

TEST(MotionLimits, sayNothingOfTheRoot) {
  Clip clip = withKneeAt({0, 0});
  clip.rotationsOf(1)[0] = axisRotation(Axis::kY, Angle::degrees(90));
  const MotionLimits limits = limitsOf(withKneeAt({0, 1, 2}));
  EXPECT_EQ(worstRatios(limits, clip).speed.ratio, 0.0);
}

TEST(WorstRatio, namesFrameAndJoint) {
  const MotionLimits limits = limitsOf(withKneeAt(steadyWithOneJump(5000, 0)));
  const Clip walk = withKneeAt(steadyWithOneJump(40, 17));
  const WorstRatio speed = worstRatios(limits, walk).speed;
  EXPECT_NEAR(speed.ratio, 4.0, 1e-6);
  EXPECT_EQ(speed.frame, 17U) << "the frame after the jump";
  EXPECT_EQ(speed.joint, JointIndex(kKnee));
  const WorstRatio acceleration = worstRatios(limits, walk).acceleration;
  EXPECT_NEAR(acceleration.ratio, Angle::degrees(3.0 * 30 * 30).radians() / 15.0, 1e-6);
  EXPECT_GE(acceleration.frame, 16U) << "where the jump begins or, as jerky, where it ends";
  EXPECT_LE(acceleration.frame, 17U);
}

TEST(WorstRatio, isThatOfAllRatesThoughFewAreLookedAt) {
  Random random(8);
  std::vector<double> degrees = {0.0};
  for (int i = 0; i < 300; ++i) degrees.push_back(degrees.back() + random.uniform(-70.0, 70.0));
  const Clip walk = withKneeAt(degrees);
  const MotionLimits limits = limitsOf(withKneeAt({0, 1, 2}));
  const TurnRates rates = turnRates(wholeOf(walk), JointIndex(kKnee));
  const auto fastest = std::max_element(rates.speeds.begin(), rates.speeds.end());
  const auto jerkiest = std::max_element(rates.accelerations.begin(), rates.accelerations.end());
  const WorstRatios worst = worstRatios(limits, walk);
  EXPECT_EQ(worst.speed.ratio, *fastest / limits.speeds[kKnee]);
  EXPECT_EQ(worst.speed.frame, static_cast<std::size_t>(fastest - rates.speeds.begin()) + 1);
  EXPECT_EQ(worst.acceleration.ratio, *jerkiest / limits.accelerations[kKnee]);
  EXPECT_EQ(worst.acceleration.frame, static_cast<std::size_t>(jerkiest - rates.accelerations.begin()) + 1);
}

TEST(WorstRatio, isZeroOfASingleFrame) {
  const MotionLimits limits = limitsOf(withKneeAt({0, 1}));
  EXPECT_EQ(worstRatios(limits, withKneeAt({0})).speed.ratio, 0.0);
  EXPECT_EQ(worstRatios(limits, withKneeAt({0})).acceleration.ratio, 0.0);
}

TEST(VisitRatios, tellsAllAboveABoundAndNoneBelow) {
  Random random(9);
  std::vector<double> degrees = {0.0};
  for (int i = 0; i < 300; ++i) degrees.push_back(degrees.back() + random.uniform(-70.0, 70.0));
  const Clip walk = withKneeAt(degrees);
  const MotionLimits limits = limitsOf(withKneeAt({0, 1, 2}));
  const ClipSpan span = {&walk, 100, 200};
  const TurnRates rates = turnRates(span, JointIndex(kKnee));
  const double least =
      0.5 * *std::max_element(rates.speeds.begin(), rates.speeds.end()) / limits.speeds[kKnee];
  std::vector<std::size_t> expected;
  for (std::size_t step = 0; step < rates.speeds.size(); ++step) {
    if (rates.speeds[step] > least * limits.speeds[kKnee]) expected.push_back(span.first + step + 1);
    if (step > 0 && rates.accelerations[step - 1] > least * limits.accelerations[kKnee])
      expected.push_back(span.first + step);
  }
  std::vector<std::size_t> told;
  visitRatios(limits, span, least, [&](std::size_t frame, double ratio) {
    EXPECT_GT(ratio, least);
    told.push_back(frame);
  });
  EXPECT_GT(expected.size(), 10U);
  EXPECT_EQ(told, expected);
}

TEST(MotionLimits, doNotLookAcrossTheEndsOfSpans) {
  const Clip clip = withKneeAt({0, 1, 2, 90, 91, 92});
  const std::vector<ClipSpan> spans = {{&clip, 0, 2}, {&clip, 3, 5}};
  EXPECT_NEAR(motionLimits(spans).speeds[kKnee], Angle::degrees(30).radians(), 1e-9);
}

}  // namespace
}  // namespace stridegraph
