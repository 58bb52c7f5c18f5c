#include "motion/resample.h"

#include <gtest/gtest.h>

#include "math/random.h"
#include "math/rotation.h"
#include "motion/test_characters.h"

namespace stridegraph {
namespace {

using testing::oneLeg;
using testing::restPose;

/// Frames at `framesPerSecond` of a leg whose root moves at 1 m/s and whose knee bends 90 degrees a second.
Clip bending(double framesPerSecond, std::size_t frames) {
  Clip clip;
  clip.name = "bending";
  clip.framesPerSecond = framesPerSecond;
  clip.jointCount = oneLeg().size();
  for (std::size_t f = 0; f < frames; ++f) {
    const double seconds = static_cast<double>(f) / framesPerSecond;
    Pose pose = restPose(oneLeg(), {0, 1, seconds});
    pose.rotations[1] = axisRotation(Axis::kX, Angle::degrees(90.0 * seconds));
    clip.append(pose.view());
  }
  return clip;
}

TEST(Resample, keepsSteadyMotionAndDuration) {
  const Clip clip = bending(120.0, 121);
  for (const double rate : {30.0, 29.97, 50.0, 60.0, 240.0}) {
    const Clip other = resample(clip, rate);
    EXPECT_EQ(other.framesPerSecond, rate);
    EXPECT_EQ(other.name, "bending");
    const double seconds = static_cast<double>(other.frameCount() - 1) / rate;
    EXPECT_LE(seconds, 1.0 + 1e-9);
    EXPECT_GT(seconds, 1.0 - 1.0 / rate - 1e-9);
    const Clip expected = bending(rate, other.frameCount());
    for (std::size_t f = 0; f < other.frameCount(); ++f) {
      EXPECT_LT((other.rootPositions[f] - expected.rootPositions[f]).norm(), 1e-9);
      EXPECT_LT(angleBetween(other.pose(f).rotations[1], expected.pose(f).rotations[1]).degrees(), 1e-4);
    }
  }
}

TEST(Resample, leavesFramesAsCapturedWhereMomentsCoincide) {
  const Clip clip = bending(120.0, 122);
  const Clip quarter = resample(clip, 30.0);
  ASSERT_EQ(quarter.frameCount(), 31U);
  for (std::size_t f = 0; f < quarter.frameCount(); ++f) {
    EXPECT_EQ(quarter.rootPositions[f], clip.rootPositions[4 * f]);
    EXPECT_EQ(quarter.pose(f).rotations[1].coeffs(), clip.pose(4 * f).rotations[1].coeffs());
  }
}

TEST(Resample, returnsTheSameAtTheSameRate) {
  const Clip clip = bending(30.0, 7);
  const Clip same = resample(clip, 30.0);
  EXPECT_EQ(same.rootPositions, clip.rootPositions);
  ASSERT_EQ(same.rotations.size(), clip.rotations.size());
  for (std::size_t i = 0; i < clip.rotations.size(); ++i) {
    EXPECT_EQ(same.rotations[i].coeffs(), clip.rotations[i].coeffs());
  }
}

TEST(Resample, makesSignsContinuousWithoutChangingRotations) {
  const Clip clip = bending(30.0, 60);
  Clip flipped = clip;
  Random random(7);
  for (Quat& rotation : flipped.rotations) {
    if (random.below(2) == 1) rotation.coeffs() *= -1.0;
  }
  const Clip result = resample(flipped, 45.0);
  for (std::size_t i = result.jointCount; i < result.rotations.size(); ++i) {
    EXPECT_GT(result.rotations[i].dot(result.rotations[i - result.jointCount]), 0.0);
  }
  const Clip expected = resample(clip, 45.0);
  for (std::size_t i = 0; i < result.rotations.size(); ++i) {
    EXPECT_LT(angleBetween(result.rotations[i], expected.rotations[i]).degrees(), 1e-5);
  }
}

TEST(Resample, countsItsFramesBeforehand) {
  for (const double rate : {7.0, 29.97, 30.0, 119.0, 120.0, 240.0}) {
    for (const std::size_t frames : {0U, 1U, 2U, 121U}) {
      EXPECT_EQ(resampledFrameCount(frames, 120.0, rate),
                resample(bending(120.0, frames), rate).frameCount());
    }
  }
}

TEST(Resample, keepsOneFrameAndNone) {
  EXPECT_EQ(resample(bending(120.0, 1), 30.0).frameCount(), 1U);
  EXPECT_EQ(resample(bending(120.0, 0), 30.0).frameCount(), 0U);
}

}  // namespace
}  // namespace stridegraph
