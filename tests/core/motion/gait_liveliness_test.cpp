#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/gait_measures.h"
#include "motion/gait_step_noise.h"
#include "motion/gait_synthesis.h"
#include "motion/gait_toes.h"
#include "motion/kinematics.h"

namespace stridegraph {
namespace {

using testing::soleAt;

constexpr double kPi = std::numbers::pi;

Clip made(const GaitRequest& request) {
  Result<Clip> clip = synthesiseGait(request);
  EXPECT_TRUE(clip.has_value());
  return clip ? *clip : Clip{};
}

GaitRequest straight(double speed, Gait gait = Gait::kWalk) {
  return {"straight", {{4.0, speed, 0.0, gait}}};
}

GaitRequest start() {
  GaitRequest request{"start", {{1.5, 0.0}, {2.0, 1.0}}};
  request.startPhase = 0.5 * kPi;
  return request;
}

Vec3 placeOf(const Clip& clip, std::size_t frame, GaitJoint joint) {
  return placeJoint(gaitSkeleton(), clip.pose(frame), JointIndex(indexOf(joint))).position;
}

Angle yawOf(const Clip& clip, std::size_t frame, GaitJoint joint) {
  const JointPlacement placed = placeJoint(gaitSkeleton(), clip.pose(frame), JointIndex(indexOf(joint)));
  return separateHeading(placed.rotation).heading.angle();
}

/// Root mean square of the angular acceleration of all joints in all frames, rad/s^2.
double rmsAcceleration(const Clip& clip) {
  const double fps = clip.framesPerSecond;
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t f = 1; f + 1 < clip.frameCount(); ++f)
    for (std::size_t j = 1; j < clip.jointCount; ++j) {
      const auto turn = [&](std::size_t from) {
        const Eigen::AngleAxisd between(clip.pose(from).rotations[j].conjugate() *
                                        clip.pose(from + 1).rotations[j]);
        return Vec3(between.axis() * Angle::radians(between.angle()).wrapped().radians());
      };
      sum += ((turn(f) - turn(f - 1)) * fps * fps).squaredNorm();
      ++count;
    }
  return std::sqrt(sum / static_cast<double>(count));
}

TEST(StepNoise, hasMeanZeroDeviationOneAndRemembersTheStepBefore) {
  Random random(3);
  const std::size_t steps = 20000;
  const StepNoise noise(random, steps);
  double mean = 0.0;
  double square = 0.0;
  double product = 0.0;
  for (std::size_t s = 0; s < steps; ++s) {
    const double now = noise.at(static_cast<double>(s));
    mean += now;
    square += now * now;
    product += now * noise.at(static_cast<double>(s + 1));
  }
  EXPECT_NEAR(mean / steps, 0.0, 0.06);
  EXPECT_NEAR(square / steps, 1.0, 0.06);
  EXPECT_NEAR(product / square, StepNoise::kMemory, 0.03);
}

TEST(StepNoise, goesOverSmoothlyAndHoldsItsEnds) {
  Random random(4);
  const StepNoise noise(random, 10);
  for (double s = 0.0; s < 10.0; s += 0.01) EXPECT_LT(std::abs(noise.at(s + 0.01) - noise.at(s)), 0.08);
  EXPECT_EQ(noise.at(-1.0), noise.at(0.0));
  EXPECT_EQ(noise.at(99.0), noise.at(10.0));
}

TEST(ToeBend, keepsTheToesFlatWhileTheHeelRisesAndNeverBendsThemDown) {
  EXPECT_EQ(toeBend(-0.3), 0.0);
  EXPECT_EQ(toeBend(0.0), 0.0);
  EXPECT_NEAR(toeBend(0.35), 0.35, 0.08);
  EXPECT_LT(toeBend(1.6), 0.75);
  for (double pitch = -0.2; pitch < 1.6; pitch += 0.01) {
    EXPECT_GE(toeBend(pitch + 0.01), toeBend(pitch));
    EXPECT_LE(toeBend(pitch + 0.01) - toeBend(pitch), 0.0101);
  }
}

TEST(SettleSole, bringsTheSoleDownAfterTheStrikeAndLeavesTheRisenHeel) {
  FootMotion foot;
  foot.heelInFoot = Vec3(0, -0.04, -0.04);
  foot.ballInFoot = Vec3(0, -0.04, 0.12);
  foot.toeFromBall = Vec3(0, 0, 0.05);
  const auto settled = [&foot](double pitch, double seconds) {
    FootMotion copy = foot;
    copy.rotation = axisRotation(Axis::kX, Angle::radians(pitch));
    settleSole(seconds, 0.1, copy);
    return pitchBeyondFlat(copy);
  };
  EXPECT_NEAR(settled(-0.2, 0.0), -0.2, 1e-12);
  EXPECT_NEAR(settled(-0.2, 0.1), 0.0, 1e-12);
  EXPECT_NEAR(settled(0.5, 0.1), 0.5, 1e-12);
  EXPECT_NEAR(settled(0.03, 0.3), 0.0, 0.005);
}

TEST(SynthesiseGait, bendsTheToesAtPushOffWithTheBallOnTheFloor) {
  const Clip clip = made(straight(1.3));
  const Quat rest = gaitPose(Gait::kWalk, {}).rotations[indexOf(GaitJoint::kLeftToes)];
  double mostBent = 0.0;
  for (std::size_t f = 0; f < clip.frameCount(); ++f)
    mostBent = std::max(mostBent,
                        angleBetween(rest, clip.pose(f).rotations[indexOf(GaitJoint::kLeftToes)]).degrees());
  EXPECT_GT(mostBent, 25.0);
  EXPECT_LT(mostBent, 45.0);
  std::size_t heelOff = 0;
  for (std::size_t f = 0; f + 1 < clip.frameCount(); ++f) {
    const Vec3 ball = placeOf(clip, f, GaitJoint::kLeftToes);
    const Vec3 next = placeOf(clip, f + 1, GaitJoint::kLeftToes);
    const bool toeStands =
        (soleAt(clip, f, Side::kLeft).toe - soleAt(clip, f + 1, Side::kLeft).toe).norm() < 5e-4;
    const double heelRise = soleAt(clip, f, Side::kLeft).heel.y() - kGaitSoleMetres;
    if (!toeStands || heelRise < 0.01 || heelRise > 0.05) continue;
    ++heelOff;
    EXPECT_LT((next - ball).norm(), 0.004) << f;
  }
  EXPECT_GT(heelOff, 5u);
}

TEST(SynthesiseGait, bendsTheKneeBeforeTheToesLeaveTheFloor) {
  const Clip clip = made(straight(1.3));
  for (std::size_t f = 1; f < clip.frameCount(); ++f) {
    const Quat& before = clip.pose(f - 1).rotations[indexOf(GaitJoint::kLeftTibia)];
    const Quat& now = clip.pose(f).rotations[indexOf(GaitJoint::kLeftTibia)];
    EXPECT_LT(angleBetween(before, now).degrees(), 21.0) << "no snap at frame " << f;
  }
}

TEST(SynthesiseGait, clearsTheFloorWithTheSwingingToes) {
  const Clip clip = made(straight(1.3));
  for (std::size_t f = 2; f + 2 < clip.frameCount(); ++f) {
    const double y = soleAt(clip, f, Side::kLeft).toe.y();
    const double speed =
        (soleAt(clip, f + 1, Side::kLeft).toe - soleAt(clip, f, Side::kLeft).toe).norm() * 30;
    const bool lowest =
        y < soleAt(clip, f - 1, Side::kLeft).toe.y() && y < soleAt(clip, f + 1, Side::kLeft).toe.y();
    if (!lowest || speed < 2.0) continue;
    EXPECT_GT(y - kGaitSoleMetres, 0.015) << f;
  }
}

TEST(SynthesiseGait, looksIntoATurnBeforeItGoesThereAndBackAfterIt) {
  GaitRequest request{"turn", {{1.5, 1.0}, {1.1, 1.0, 1.4}, {1.5, 1.0}}};
  request.startPhase = 0.0;
  const Clip clip = made(request);
  const auto crossing = [&clip](GaitJoint joint) {
    for (std::size_t f = 0; f < clip.frameCount(); ++f)
      if (yawOf(clip, f, joint).degrees() > 45.0) return static_cast<double>(f) / clip.framesPerSecond;
    return 0.0;
  };
  const double lead = crossing(GaitJoint::kPelvis) - crossing(GaitJoint::kHead);
  EXPECT_GE(lead, 0.2);
  EXPECT_LE(lead, 0.4);
  const std::size_t last = clip.frameCount() - 1;
  EXPECT_NEAR(
      (yawOf(clip, last, GaitJoint::kHead) - yawOf(clip, last, GaitJoint::kPelvis)).wrapped().degrees(), 0.0,
      12.0);
}

TEST(SynthesiseGait, keepsTheEyesLevel) {
  const Clip clip = made(straight(1.3));
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    const JointPlacement head =
        placeJoint(gaitSkeleton(), clip.pose(f), JointIndex(indexOf(GaitJoint::kHead)));
    EXPECT_LT(std::abs(std::asin((head.rotation * Vec3::UnitX()).y())), 0.07) << "roll";
    EXPECT_LT(std::abs(std::asin((head.rotation * Vec3::UnitZ()).y())), 0.17) << "pitch";
  }
}

TEST(SynthesiseGait, shiftsTheWeightBeforeTheFirstStep) {
  const Clip clip = made(start());
  std::size_t liftOff = 0;
  while (liftOff + 1 < clip.frameCount() &&
         soleAt(clip, liftOff, Side::kLeft).toe.y() < kGaitSoleMetres + 0.01 &&
         soleAt(clip, liftOff, Side::kRight).toe.y() < kGaitSoleMetres + 0.01)
    ++liftOff;
  ASSERT_GT(liftOff, 15u);
  const Vec3 left = placeOf(clip, liftOff, GaitJoint::kLeftFoot);
  const Vec3 right = placeOf(clip, liftOff, GaitJoint::kRightFoot);
  const double carrying =
      soleAt(clip, liftOff, Side::kLeft).toe.y() > soleAt(clip, liftOff, Side::kRight).toe.y() ? right.x()
                                                                                               : left.x();
  const double root = clip.rootPositions[liftOff].x();
  EXPECT_LT(std::abs(root - carrying), 0.6 * std::abs(0.5 * (left.x() - right.x())));
  EXPECT_NEAR(clip.rootPositions[0].x() - 0.5 * (placeOf(clip, 0, GaitJoint::kLeftFoot).x() +
                                                 placeOf(clip, 0, GaitJoint::kRightFoot).x()),
              0.0, 0.01);
}

TEST(SynthesiseGait, fallsFreelyInTheFlightOfAJog) {
  const Clip clip = made(straight(2.8, Gait::kJog));
  const double fps = clip.framesPerSecond;
  std::size_t flying = 0;
  double lowest = 9.0;
  double highest = 0.0;
  for (std::size_t f = 1; f + 1 < clip.frameCount(); ++f) {
    const auto aloft = [&clip, f](Side side) {
      const testing::Sole sole = soleAt(clip, f, side);
      return std::min(sole.heel.y(), sole.toe.y()) > kGaitSoleMetres + 0.02;
    };
    lowest = std::min(lowest, clip.rootPositions[f].y());
    highest = std::max(highest, clip.rootPositions[f].y());
    if (!aloft(Side::kLeft) || !aloft(Side::kRight)) continue;
    ++flying;
    const double up =
        clip.rootPositions[f + 1].y() - 2 * clip.rootPositions[f].y() + clip.rootPositions[f - 1].y();
    EXPECT_NEAR(up * fps * fps, -9.81, 1.0) << f;
  }
  EXPECT_GT(flying, 15u);
  EXPECT_NEAR(highest - lowest, 0.09, 0.012);
}

TEST(SynthesiseGait, repeatsItselfOnlyWithoutVariation) {
  GaitRequest request = straight(1.3);
  const Clip alive = made(request);
  EXPECT_EQ(alive.rootPositions, made(request).rootPositions);
  request.seed = 2;
  EXPECT_NE(alive.rootPositions, made(request).rootPositions);
  request.variation = 0.0;
  EXPECT_LT(rmsAcceleration(made(request)), 0.9 * rmsAcceleration(alive))
      << "livelier than a mean of strides";
}

}  // namespace
}  // namespace stridegraph
