#include "gait_fit/fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "gait_fit/held_out.h"
#include "gait_fit/side_laws.h"
#include "gait_fit/table.h"
#include "gait_fit/walker.h"
#include "math/random.h"
#include "math/rotation.h"

namespace stridegraph::gait_fit {
namespace {

using Eigen::Index;
using testing::clipsOf;
using testing::largestDistance;
using testing::makeWalk;
using testing::variedWalks;

const std::vector<testing::KnownWalk>& known() {
  static const std::vector<testing::KnownWalk> walks = variedWalks();
  return walks;
}

const GaitFit& knownFit() {
  static const Result<GaitFit> fit = fitGait(clipsOf(known()), fitParamsFor(Gait::kWalk));
  return *fit;
}

std::string refusal(std::vector<Clip> clips) {
  const Result<GaitFit> fit = fitGait(std::move(clips), fitParamsFor(Gait::kWalk));
  return fit ? "accepted" : fit.error().message;
}

Clip straight(double speed, double seconds) {
  return makeWalk({seconds, [=](double) { return speed; }, [](double) { return 0.0; }}).clip;
}

TEST(FitGait, findsThePhaseThatAKnownWalkWasMadeWith) {
  double squares = 0.0;
  double frames = 0.0;
  for (std::size_t t = 0; t < known().size(); ++t)
    for (Index f = 5; f + 5 < knownFit().tracks[t].frames(); ++f) {
      const double apart =
          knownFit().tracks[t].phase[f] - known()[t].states[static_cast<std::size_t>(f)].phase;
      squares += std::pow(std::remainder(apart, 2.0 * std::numbers::pi), 2.0);
      frames += 1.0;
    }
  EXPECT_LT(std::sqrt(squares / frames), 0.06) << "rad rms";
}

TEST(FitGait, findsThePosesThatAKnownWalkWasMadeWith) {
  const Result<GaitTable> table = tableOf(knownFit().series, {}, 1.0);
  ASSERT_TRUE(table.has_value());
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    const GaitState state{random.uniform(0, 2 * std::numbers::pi), random.uniform(1.1, 1.5),
                          random.uniform(-0.4, 0.4)};
    EXPECT_LT(largestDistance(gaitPose(*table, state), gaitPose(Gait::kWalk, state)), 0.06) << "metres";
  }
}

TEST(FitGait, findsTheMainCoefficientsOfAKnownWalk) {
  const Result<GaitTable> table = tableOf(knownFit().series, {}, 1.0);
  ASSERT_TRUE(table.has_value());
  const GaitTable& truth = gaitTable(Gait::kWalk);
  for (const StoredJoint joint : {StoredJoint::kFemur, StoredJoint::kTibia, StoredJoint::kHumerus}) {
    const auto j = static_cast<std::size_t>(joint);
    for (std::size_t term = 1; term < 5; ++term)
      EXPECT_NEAR(table->joints[j][0][0][term], truth.joints[j][0][0][term], 250)
          << "joint " << j << " term " << term;
  }
}

TEST(FitGait, isExactlyMirrorSymmetrical) {
  const Result<GaitTable> table = tableOf(knownFit().series, {}, 1.0);
  ASSERT_TRUE(table.has_value());
  Random random(6);
  for (int i = 0; i < 50; ++i) {
    const GaitState state{random.uniform(0, 2 * std::numbers::pi), random.uniform(0.9, 1.8),
                          random.uniform(-1.5, 1.5), random.uniform(-3, 3), random.uniform(-1, 1)};
    EXPECT_LT(largestDistance(gaitPose(*table, mirrored(state)), mirrored(gaitPose(*table, state))), 1e-9);
  }
}

TEST(FitGait, knowsATurnFromItsMirrorImage) {
  const auto bending = [](double side) {
    return makeWalk({4.0, [](double) { return 1.2; }, [=](double t) { return side * std::sin(t); }}).clip;
  };
  const Result<GaitFit> left = fitGait({bending(1.0), straight(1.1, 4.0)}, fitParamsFor(Gait::kWalk));
  ASSERT_TRUE(left.has_value());
  Clip mirroredTurn = bending(1.0);
  for (std::size_t f = 0; f < mirroredTurn.frameCount(); ++f) {
    const PoseView view = mirroredTurn.pose(f);
    const Pose twin = mirrored(Pose{view.rootPosition, {view.rotations.begin(), view.rotations.end()}});
    mirroredTurn.rootPositions[f] = twin.rootPosition;
    std::copy(twin.rotations.begin(), twin.rotations.end(), mirroredTurn.rotationsOf(f).begin());
  }
  const Result<GaitFit> right = fitGait({mirroredTurn, straight(1.1, 4.0)}, fitParamsFor(Gait::kWalk));
  ASSERT_TRUE(right.has_value());
  EXPECT_LT((left->series.coefficients - right->series.coefficients).cwiseAbs().maxCoeff(), 2e-3);
}

TEST(MeasureSideLaws, findsTheCadenceAndSlipOfAKnownWalk) {
  const Result<SideLaws> laws = measureSideLaws(knownFit());
  ASSERT_TRUE(laws.has_value());
  for (const double u : {-0.3, 0.0, 0.3}) {
    const double found = laws->cadence[0] + laws->cadence[1] * u + laws->cadence[2] * u * u;
    EXPECT_NEAR(found, gaitCadence(Gait::kWalk, 1.3 + u, 0.0), 0.1) << "rad/s at u = " << u;
  }
  EXPECT_NEAR(laws->slip[0], gaitSlip(Gait::kWalk, 1.0, 0.0).radians(), 0.03);
}

TEST(HeelInFoot, isLevelWithTheToeEndOfTheFlatFoot) {
  const Angle pitch = Angle::degrees(12);
  const auto heel = heelInFoot(pitch);
  const Quat flat = axisRotation(Axis::kX, pitch);
  const Quat toes = gaitPose(Gait::kWalk, {}).rotations[indexOf(GaitJoint::kLeftToes)];
  const Vec3 toeEnd = Vec3(0, 0, 0.117758) + toes * Vec3(0, 0, 0.05);
  EXPECT_NEAR((flat * Vec3(heel[0], heel[1], heel[2])).y(), (flat * toeEnd).y(), 1e-12);
  EXPECT_NEAR((flat * Vec3(heel[0], heel[1], heel[2])).z(), -0.045, 1e-12);
}

TEST(FitGait, refusesClipsThatShowNoGait) {
  EXPECT_EQ(refusal({}), "found no clips to fit a gait to, expected at least one");
  EXPECT_EQ(refusal({straight(1.2, 0.5)}), "found 16 frames, expected at least 20 to see a stride in");
  EXPECT_NE(refusal({straight(0.2, 3.0)}).find("m/s, expected more than 0.5"), std::string::npos);
  EXPECT_NE(refusal({straight(1.2, 1.5)}).find("strides in all clips, expected at least 3"),
            std::string::npos);
}

TEST(FitGait, refusesAnotherBodyAndAnotherRateAndNamesTheClip) {
  Clip other = straight(1.2, 3.0);
  other.framesPerSecond = 60.0;
  other.name = "sixty";
  const Result<GaitFit> fit = fitGait({other}, fitParamsFor(Gait::kWalk));
  ASSERT_FALSE(fit.has_value());
  EXPECT_EQ(fit.error().place.file, "sixty");
  EXPECT_EQ(fit.error().message,
            "found a clip of 24 joints at 60 frames a second, expected the gait body's 24 at 30");
}

TEST(MeasureHeldOut, tellsAKnownWalkThatItHasNotSeen) {
  const Result<HeldOutFigures> figures = measureHeldOut(knownFit());
  ASSERT_TRUE(figures.has_value());
  EXPECT_LT(figures->heldOut.allJoints, 1.5) << "degrees";
  EXPECT_GE(figures->heldOut.allJoints, 0.95 * figures->trained.allJoints);
  EXPECT_EQ(figures->clips.size(), known().size());
  EXPECT_NEAR(figures->lean.heldOut / figures->lean.captured, 1.0, 0.1);
}

TEST(MeasureHeldOut, needsAClipToLeaveOut) {
  const Result<GaitFit> fit = fitGait({straight(1.2, 5.0)}, fitParamsFor(Gait::kWalk));
  ASSERT_TRUE(fit.has_value());
  const Result<HeldOutFigures> figures = measureHeldOut(*fit);
  ASSERT_FALSE(figures.has_value());
  EXPECT_EQ(figures.error().message, "found one clip, expected at least two to leave one out");
}

}  // namespace
}  // namespace stridegraph::gait_fit
