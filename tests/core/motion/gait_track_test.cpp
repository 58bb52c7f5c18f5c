#include "motion/gait_track.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace stridegraph {
namespace {

constexpr double kPi = std::numbers::pi;

GaitTrack laid(const GaitRequest& request) {
  Result<GaitTrack> track = layTrack(request);
  EXPECT_TRUE(track.has_value());
  return track ? *track : GaitTrack{};
}

const GaitMoment& first(const GaitTrack& track) {
  return track.moments[track.margin];
}

const GaitMoment& last(const GaitTrack& track) {
  return track.moments[track.moments.size() - 1 - track.margin];
}

GaitRequest leftTurn(double turnRate) {
  return {"turn", {{1.0, 1.0}, {0.5 * kPi / turnRate, 1.0, turnRate}, {1.0, 1.0}}};
}

TEST(LayTrack, startsAtTheOriginAndGoesStraight) {
  GaitRequest request{"straight", {{2.0, 1.5}}};
  request.variation = 0.0;
  const GaitTrack track = laid(request);
  EXPECT_EQ(first(track).place, Vec2::Zero());
  EXPECT_NEAR(last(track).place.y(), 1.5 * 59.0 / 30.0, 1e-9);
  EXPECT_NEAR(last(track).place.x(), 0.0, 1e-12);
}

TEST(LayTrack, turnsByTheWholeAngleHoweverItIsSmoothed) {
  for (const double rate : {0.5, 1.1, 1.7, 2.2}) {
    const GaitTrack track = laid(leftTurn(rate));
    EXPECT_NEAR(last(track).heading.degrees() - first(track).heading.degrees(), 90.0, 1e-6) << rate;
  }
}

TEST(LayTrack, changesSpeedWithoutSteps) {
  const GaitTrack track = laid({"ramp", {{2.0, 0.0}, {2.0, 1.3}}});
  for (std::size_t i = 1; i < track.moments.size(); ++i)
    EXPECT_LT(std::abs(track.moments[i].speed - track.moments[i - 1].speed), 0.1);
}

TEST(LayTrack, advancesThePhaseByTheCadence) {
  GaitRequest request{"straight", {{2.0, 1.3}}};
  request.variation = 0.0;
  const GaitTrack track = laid(request);
  EXPECT_NEAR(last(track).phase - first(track).phase, gaitCadence(Gait::kWalk, 1.3, 0.0) * 59.0 / 30.0, 1e-9);
}

TEST(LayTrack, variesStepsByAPercentAboutTheLaw) {
  GaitRequest request{"straight", {{30.0, 1.3}}};
  const GaitTrack track = laid(request);
  double smallest = 9.0;
  double largest = 0.0;
  for (const GaitMoment& moment : track.moments) {
    smallest = std::min(smallest, moment.speed);
    largest = std::max(largest, moment.speed);
  }
  EXPECT_GT(largest - smallest, 0.01 * 1.3);
  EXPECT_LT(largest - smallest, 0.10 * 1.3);
  request.seed = 2;
  EXPECT_NE(last(laid(request)).phase, last(track).phase);
}

TEST(LayTrack, bringsThePhaseToWhatIsAskedAtEitherEnd) {
  GaitRequest request{"straight", {{3.0, 1.0}}};
  request.endPhase = 1.0;
  EXPECT_NEAR(last(laid(request)).phase, 1.0, 1e-9);
  request.startPhase = 0.5;
  const GaitTrack both = laid(request);
  EXPECT_NEAR(first(both).phase, 0.5, 1e-9);
  EXPECT_NEAR(std::remainder(last(both).phase - 1.0, 2 * kPi), 0.0, 1e-9);
}

TEST(LayTrack, turnsTightlyMostlyOverTheOuterFoot) {
  double outer = 0.0;
  double inner = 0.0;
  for (const GaitMoment& moment : laid({"circle", {{8.0, 1.0, 1.6}}}).moments) {
    const double leftCarries = std::cos(moment.phase - contactAt(moment).middle());
    (leftCarries > 0.0 ? inner : outer) += moment.turnRate;
  }
  EXPECT_GT(outer, 1.5 * inner);
}

TEST(WalkingShare, isNothingInStandingAndAllFromTheSlowestMeasuredWalk) {
  GaitMoment moment;
  EXPECT_EQ(walkingShare(moment), 0.0);
  moment.speed = 0.75;
  EXPECT_EQ(walkingShare(moment), 1.0);
}

TEST(SteppingShare, needsATurnOnTheSpot) {
  GaitMoment moment;
  EXPECT_EQ(steppingShare(moment), 0.0);
  moment.turnRate = 1.2;
  EXPECT_EQ(steppingShare(moment), 1.0);
  moment.speed = 1.0;
  EXPECT_EQ(steppingShare(moment), 0.0);
}

TEST(ContactAt, lastsTheWholeCycleWhenStanding) {
  GaitMoment moment;
  EXPECT_NEAR(contactAt(moment).halfWidth(), kPi, 1e-12);
  moment.speed = 1.2;
  EXPECT_LT(contactAt(moment).halfWidth(), 0.65 * kPi);
}

}  // namespace
}  // namespace stridegraph
