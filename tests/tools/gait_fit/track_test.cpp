#include "gait_fit/track.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>

#include "gait_fit/spline.h"
#include "gait_fit/walker.h"

namespace stridegraph::gait_fit {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

TEST(CubicSpline, reproducesACubicWithItsSlopes) {
  const Spline spline = cubicSpline(40, 6.0, 30.0);
  VectorXd values(40), slopes(40);
  for (Index f = 0; f < 40; ++f) {
    const double t = static_cast<double>(f) / 30.0;
    values[f] = 2.0 - t + 3.0 * t * t - t * t * t;
    slopes[f] = -1.0 + 6.0 * t - 3.0 * t * t;
  }
  const VectorXd found =
      (spline.values.transpose() * spline.values).ldlt().solve(spline.values.transpose() * values);
  EXPECT_LT((spline.values * found - values).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((spline.slopes * found - slopes).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(CubicSpline, penalisesNoParabola) {
  const Spline spline = cubicSpline(40, 6.0, 30.0);
  VectorXd parabola(spline.values.cols());
  for (Index i = 0; i < parabola.size(); ++i) parabola[i] = static_cast<double>(i * i);
  EXPECT_LT((spline.thirdDifferences * parabola).norm(), 1e-9);
}

TEST(Unwrapped, leavesNoWholeTurns) {
  const VectorXd angles = unwrapped((VectorXd(4) << 3.0, -3.0, 3.0, 0.0).finished());
  EXPECT_NEAR(angles[1], 2.0 * std::numbers::pi - 3.0, 1e-12);
  EXPECT_NEAR(angles[2], 3.0, 1e-12);
}

class BendingWalk : public ::testing::Test {
 protected:
  void SetUp() override {
    track_.clip = known_.clip;
    for (int round = 0; round < 2; ++round) {
      splitRoot({}, track_);
      estimatePhase(0.5, track_);
    }
    splitRoot({}, track_);
  }
  const testing::KnownWalk known_ = testing::makeWalk({5.0, [](double t) { return 1.2 + 0.2 * std::sin(t); },
                                                       [](double t) { return 0.7 * std::sin(1.2 * t); }});
  Track track_;
};

TEST_F(BendingWalk, isSplitIntoTheSpeedAndTurnRateThatItWasMadeWith) {
  for (Index f = 8; f + 8 < track_.frames(); ++f) {
    const GaitState& state = known_.states[static_cast<std::size_t>(f)];
    EXPECT_NEAR(track_.speed[f], state.speed, 0.05) << "frame " << f;
    EXPECT_NEAR(track_.turnRate[f], state.turnRate, 0.15) << "frame " << f;
  }
}

TEST_F(BendingWalk, hasAFirstPhaseNearTheTrueOne) {
  for (Index f = 8; f + 8 < track_.frames(); ++f) {
    const double apart = track_.phase[f] - known_.states[static_cast<std::size_t>(f)].phase;
    EXPECT_NEAR(std::remainder(apart, 2.0 * std::numbers::pi), 0.0, 0.35) << "frame " << f;
  }
}

TEST(EstimatePhase, takesNoFrameForGoingThatIsSlow) {
  Track track;
  track.clip = testing::makeWalk({2.0, [](double) { return 0.3; }, [](double) { return 0.0; }}).clip;
  splitRoot({}, track);
  estimatePhase(0.5, track);
  EXPECT_EQ(track.going.sum(), 0.0);
}

}  // namespace
}  // namespace stridegraph::gait_fit
