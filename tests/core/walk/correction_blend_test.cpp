#include "walk/correction_blend.h"

#include <gtest/gtest.h>

#include <numeric>

namespace stridegraph {
namespace {

FootCorrection alongX(double metres) {
  return {metres, 0.0, 0.0, 0.0, 0.0};
}

/// Corrections along x that grow evenly over 10 frames.
PinnedStance growing(std::size_t first, double from, double step) {
  PinnedStance pinned{{first, first + 9}, {}};
  for (int i = 0; i < 10; ++i) pinned.corrections.push_back(alongX(from + step * i));
  return pinned;
}

/// The largest change of slope from frame to frame.
double sharpestCorner(const std::vector<FootCorrection>& corrections) {
  double sharpest = 0.0;
  for (std::size_t f = 1; f + 1 < corrections.size(); ++f)
    sharpest =
        std::max(sharpest, (corrections[f + 1] - 2.0 * corrections[f] + corrections[f - 1]).head<3>().norm());
  return sharpest;
}

TEST(CarryCorrections, keepsWhatIsPinned) {
  const std::vector<PinnedStance> stances = {growing(20, 0.0, 0.003), growing(60, 0.01, 0.0)};
  const std::vector<FootCorrection> all = carryCorrections(stances, 90, 9);
  for (const PinnedStance& pinned : stances)
    for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(all[pinned.stance.first + i], pinned.corrections[i]);
}

TEST(CarryCorrections, fadesWithoutCornersAndIsZeroFartherAway) {
  const std::vector<FootCorrection> all = carryCorrections(std::vector{growing(20, 0.0, 0.003)}, 60, 9);
  EXPECT_LT(sharpestCorner(all), 0.003) << "a jump would be 0.027, a kink 0.003";
  for (std::size_t f = 0; f < 60; ++f) {
    if (f < 11 || f > 38) {
      EXPECT_EQ(all[f], FootCorrection::Zero()) << f;
    }
  }
  EXPECT_GT(all[30][0], 0.027) << "it goes on as it came before it turns back";
}

TEST(CarryCorrections, leadsFromOneStanceToTheNextWhereTheyAreNear) {
  const std::vector<FootCorrection> all =
      carryCorrections(std::vector{growing(0, 0.02, 0.0), growing(22, 0.04, 0.0)}, 32, 9);
  EXPECT_NEAR((all[15] + all[16])[0] / 2, 0.03, 1e-12) << "half way";
  EXPECT_LT(sharpestCorner(all), 0.001);
}

TEST(CarryCorrections, isZeroWithoutStances) {
  for (const FootCorrection& correction : carryCorrections({}, 5, 9))
    EXPECT_EQ(correction, FootCorrection::Zero());
}

TEST(CarryCorrections, cutsAFadeOffAtTheEndsOfTheClip) {
  const std::vector<FootCorrection> all = carryCorrections(std::vector{growing(3, 0.02, 0.0)}, 16, 9);
  EXPECT_GT(all[0][0], 0.01) << "three frames are not enough to fade in";
  EXPECT_GT(all[15][0], 0.01);
}

TEST(SmoothEnvelope, liesOverItsValuesWithoutACorner) {
  std::vector<double> values(60, 0.0);
  values[30] = 1.0;
  const std::vector<double> envelope = smoothEnvelope(values, 4);
  EXPECT_EQ(envelope[30], 1.0);
  for (std::size_t f = 0; f < 60; ++f) {
    if (f < 22 || f > 38) {
      EXPECT_EQ(envelope[f], 0.0) << f;
    }
    if (f > 0) {
      EXPECT_LT(std::abs(envelope[f] - envelope[f - 1]), 0.25);
    }
  }
}

TEST(SmoothMean, followsTheValuesThatHaveWeight) {
  std::vector<double> values(80, 7.0);
  std::vector<double> weights(80, 0.0);
  for (std::size_t f = 30; f < 50; ++f) {
    values[f] = 0.02;
    weights[f] = 1.0;
  }
  const std::vector<double> mean = smoothMean(values, weights, 10);
  EXPECT_NEAR(mean[40], 0.02, 0.002);
  EXPECT_EQ(mean[19], 0.0) << "beyond its reach";
  for (std::size_t f = 1; f < 80; ++f) EXPECT_LT(std::abs(mean[f] - mean[f - 1]), 0.008);
}

}  // namespace
}  // namespace stridegraph
