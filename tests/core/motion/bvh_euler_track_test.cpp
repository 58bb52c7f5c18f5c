#include "motion/bvh_euler_track.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "math/random.h"

namespace stridegraph {
namespace {

constexpr std::array<EulerOrder, 6> kOrders = {{{Axis::kX, Axis::kY, Axis::kZ},
                                                {Axis::kX, Axis::kZ, Axis::kY},
                                                {Axis::kY, Axis::kX, Axis::kZ},
                                                {Axis::kY, Axis::kZ, Axis::kX},
                                                {Axis::kZ, Axis::kX, Axis::kY},
                                                {Axis::kZ, Axis::kY, Axis::kX}}};

BvhEulerTrack trackOf(const EulerOrder& order, const std::vector<Quat>& rotations) {
  return bvhEulerTrack({order.begin(), order.end()}, rotations);
}

Quat fromDegrees(const EulerOrder& order, const std::array<double, 3>& degrees) {
  return fromEuler(order,
                   {Angle::degrees(degrees[0]), Angle::degrees(degrees[1]), Angle::degrees(degrees[2])});
}

double largestChange(const BvhEulerTrack& track) {
  double largest = 0.0;
  for (std::size_t f = 1; f < track.degrees.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
      largest = std::max(largest, std::abs(track.degrees[f][i] - track.degrees[f - 1][i]));
  return largest;
}

double largestError(const EulerOrder& order, const BvhEulerTrack& track, const std::vector<Quat>& rotations) {
  double largest = 0.0;
  for (std::size_t f = 0; f < rotations.size(); ++f)
    largest = std::max(largest, angleBetween(fromDegrees(order, track.degrees[f]), rotations[f]).degrees());
  return largest;
}

/// A rotation whose axis and speed drift, up to 5 degrees a frame.
std::vector<Quat> wandering(Random& random, std::size_t frames) {
  std::vector<Quat> rotations;
  Quat rotation = Quat::Identity();
  Vec3 turn = Vec3::Zero();
  for (std::size_t f = 0; f < frames; ++f) {
    const Vec3 push(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    turn += Angle::degrees(0.6).radians() * push;
    const double most = Angle::degrees(5.0).radians();
    if (turn.norm() > most) turn *= most / turn.norm();
    rotation = (rotation * fromRotationVector(turn)).normalized();
    rotations.push_back(rotation);
  }
  return rotations;
}

TEST(BvhEulerTrack, neverJumpsByHalfATurnWhileARotationWanders) {
  Random random(5);
  for (const EulerOrder& order : kOrders) {
    for (int sample = 0; sample < 20; ++sample) {
      const std::vector<Quat> rotations = wandering(random, 1500);
      const BvhEulerTrack track = trackOf(order, rotations);
      // Close by gimbal lock the outer angles must turn by a quarter, and no more than that.
      EXPECT_LT(largestChange(track), 100.0);
      EXPECT_LT(largestError(order, track, rotations), 2e-3);
    }
  }
}

TEST(BvhEulerTrack, passesThroughGimbalLockAtTheRotationsOwnPace) {
  for (const EulerOrder& order : kOrders) {
    for (const double pole : {90.0, -90.0}) {
      std::vector<Quat> rotations;
      for (int f = -30; f <= 30; ++f) rotations.push_back(fromDegrees(order, {20.0, pole + f, -35.0}));
      const BvhEulerTrack track = trackOf(order, rotations);
      EXPECT_LT(largestChange(track), 1.001);
      EXPECT_LT(largestError(order, track, rotations), 2e-3);
    }
  }
}

TEST(BvhEulerTrack, staysContinuousWhileARotationLiesInGimbalLock) {
  for (const EulerOrder& order : kOrders) {
    for (const double pole : {90.0, -90.0}) {
      std::vector<Quat> rotations;
      for (int f = 0; f < 200; ++f) rotations.push_back(fromDegrees(order, {10.0 + 2.0 * f, pole, 3.0 * f}));
      const BvhEulerTrack track = trackOf(order, rotations);
      // The first frame is free to share what it turns between both outer angles.
      EXPECT_LT(largestChange(track), 2.6);
      EXPECT_LT(largestError(order, track, rotations), 2e-3);
    }
  }
}

TEST(BvhEulerTrack, countsWholeTurns) {
  for (const EulerOrder& order : kOrders) {
    for (std::size_t axis = 0; axis < 3; axis += 2) {
      std::vector<Quat> rotations;
      for (int f = 0; f <= 1440; ++f) {
        std::array<double, 3> degrees = {0.0, 20.0, 0.0};
        degrees[axis] = 10.0 * f;
        rotations.push_back(fromDegrees(order, degrees));
      }
      const BvhEulerTrack track = trackOf(order, rotations);
      EXPECT_NEAR(track.degrees.back()[axis], 14400.0, 1e-6);
      EXPECT_LT(largestChange(track), 10.001);
    }
  }
}

TEST(BvhEulerTrack, keepsTwoAxesThroughTheLockOfTheThird) {
  const std::vector<Axis> axes = {Axis::kX, Axis::kZ};
  std::vector<Quat> rotations;
  for (int f = 0; f <= 60; ++f)
    rotations.push_back(axisRotation(Axis::kX, Angle::degrees(5.0 * f)) *
                        axisRotation(Axis::kZ, Angle::degrees(60.0 + f)));
  const BvhEulerTrack track = bvhEulerTrack(axes, rotations);
  EXPECT_EQ(track.axes, axes);
  for (int f = 0; f <= 60; ++f) {
    EXPECT_NEAR(track.degrees[static_cast<std::size_t>(f)][0], 5.0 * f, 1e-4);
    EXPECT_NEAR(track.degrees[static_cast<std::size_t>(f)][1], 60.0 + f, 1e-4);
  }
}

}  // namespace
}  // namespace stridegraph
