#include "motion/glb_tracks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "math/random.h"
#include "math/rotation.h"

namespace stridegraph {
namespace {

/// A clip of a single joint.
Clip turning(std::size_t frames, const std::function<Quat(std::size_t)>& rotationAt) {
  Clip clip;
  clip.jointCount = 1;
  for (std::size_t f = 0; f < frames; ++f) {
    const Pose pose{{0, 1, 0}, {rotationAt(f)}};
    clip.append(pose.view());
  }
  return clip;
}

void expectContinuous(const std::vector<float>& keys) {
  for (std::size_t i = 4; i + 3 < keys.size(); i += 4) {
    double dot = 0.0;
    for (std::size_t k = 0; k < 4; ++k)
      dot += static_cast<double>(keys[i + k]) * static_cast<double>(keys[i - 4 + k]);
    EXPECT_GE(dot, 0.0);
  }
}

TEST(RotationKeys, neverTurnTheSignBetweenNeighbours) {
  Random random(9);
  const auto any = [&](std::size_t) {
    return Quat(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  };
  expectContinuous(rotationKeys(turning(5000, any), 0));
  // Half turns from frame to frame: the dot product is nothing but rounding.
  const Quat half = axisRotation(Axis::kX, Angle::degrees(180.0));
  const Quat first(0.1, 0.7, -0.3, 0.5);
  expectContinuous(
      rotationKeys(turning(100, [&](std::size_t f) { return f % 2 == 0 ? first : half * first; }), 0));
}

TEST(RotationKeys, areOfUnitLengthAndNoTurnForWhatIsNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Quat& none : {Quat(0, 0, 0, 0), Quat(nan, 0, 0, 0)})
    EXPECT_EQ(rotationKey(none), (std::array<float, 4>{0, 0, 0, 1}));
  EXPECT_EQ(rotationKey(Quat(0, 3, 0, 0)), (std::array<float, 4>{1, 0, 0, 0}));
}

TEST(KeyTimes, beginAtZeroAndGrowHoweverFastAndLongAClipIs) {
  for (const double rate : {1e-3, 29.97, 30.0, 240.0, 1e6}) {
    Clip clip;
    clip.framesPerSecond = rate;
    clip.rootPositions.resize(120'000);
    const std::vector<float> times = keyTimes(clip);
    ASSERT_EQ(times.size(), clip.frameCount());
    EXPECT_EQ(times[0], 0.0F);
    for (std::size_t f = 1; f < times.size(); ++f) EXPECT_GT(times[f], times[f - 1]);
    EXPECT_NEAR(times.back(), 119'999.0 / rate, 1e-6 * 119'999.0 / rate);
  }
}

TEST(FiniteFloat, boundsWhatSinglePrecisionCannotHold) {
  EXPECT_EQ(finiteFloat(std::numeric_limits<double>::quiet_NaN()), 0.0F);
  EXPECT_EQ(finiteFloat(-1e300), std::numeric_limits<float>::lowest());
  EXPECT_EQ(finiteFloat(std::numeric_limits<double>::infinity()), std::numeric_limits<float>::max());
  EXPECT_EQ(finiteFloat(0.25), 0.25F);
}

}  // namespace
}  // namespace stridegraph
