#include "math/rotation.h"

#include <gtest/gtest.h>

#include "math/random.h"

namespace stridegraph {
namespace {

constexpr std::array<EulerOrder, 6> kOrders = {{{Axis::kX, Axis::kY, Axis::kZ},
                                                {Axis::kY, Axis::kZ, Axis::kX},
                                                {Axis::kZ, Axis::kX, Axis::kY},
                                                {Axis::kX, Axis::kZ, Axis::kY},
                                                {Axis::kZ, Axis::kY, Axis::kX},
                                                {Axis::kY, Axis::kX, Axis::kZ}}};

TEST(Euler, anglesGiveTheirRotationBackInEveryOrder) {
  Random random(1);
  for (const EulerOrder& order : kOrders) {
    for (int i = 0; i < 200; ++i) {
      const Quat rotation =
          fromEuler(order, {Angle::radians(random.uniform(-3, 3)), Angle::radians(random.uniform(-3, 3)),
                            Angle::radians(random.uniform(-3, 3))});
      EXPECT_LT(angleBetween(rotation, fromEuler(order, toEuler(order, rotation))).radians(), 1e-7);
    }
  }
}

TEST(Euler, anglesGiveTheirRotationBackWhereTwoAxesFallTogether) {
  Random random(2);
  for (const EulerOrder& order : kOrders) {
    for (const double middle : {-90.0, 90.0}) {
      const Quat rotation = fromEuler(
          order, {Angle::degrees(random.uniform(-180, 180)), Angle::degrees(middle), Angle::degrees(30)});
      EXPECT_LT(angleBetween(rotation, fromEuler(order, toEuler(order, rotation))).degrees(), 1e-4);
    }
  }
}

TEST(Slerp, isTheSameBySeriesAsBySines) {
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const Quat from =
        fromRotationVector({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
    const Vec3 axis = Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1)).normalized();
    const double angle = random.uniform(0.0, 2.0);
    const double fraction = random.uniform();
    Quat to = from * fromRotationVector(angle * axis);
    if (i % 2 == 0) to.coeffs() = -to.coeffs();
    const Quat expected = from * fromRotationVector(fraction * angle * axis);
    EXPECT_LT((slerp(from, to, fraction).coeffs() - expected.coeffs()).norm(), 1e-14) << "angle " << angle;
  }
}

TEST(Slerp, givesBothEndsAndHalvesTheAngle) {
  const Quat from = axisRotation(Axis::kX, Angle::degrees(10));
  const Quat to = axisRotation(Axis::kX, Angle::degrees(50));
  EXPECT_LT(angleBetween(slerp(from, to, 0.0), from).degrees(), 1e-6);
  EXPECT_LT(angleBetween(slerp(from, to, 1.0), to).degrees(), 1e-6);
  EXPECT_NEAR(angleBetween(from, slerp(from, to, 0.5)).degrees(), 20.0, 1e-6);
}

TEST(Slerp, takesTheShorterArcWhateverTheSigns) {
  const Quat from = axisRotation(Axis::kY, Angle::degrees(170));
  Quat to = axisRotation(Axis::kY, Angle::degrees(-170));
  to.coeffs() = -to.coeffs();
  EXPECT_NEAR(angleBetween(from, slerp(from, to, 0.5)).degrees(), 10.0, 1e-6);
}

TEST(RotationVector, givesBackAxisAndAngleWhateverTheSign) {
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const Vec3 vector(random.uniform(-1.8, 1.8), random.uniform(-1.8, 1.8), random.uniform(-1.7, 1.7));
    Quat rotation = fromRotationVector(vector);
    EXPECT_NEAR(rotation.norm(), 1.0, 1e-12);
    if (i % 2 == 1) rotation.coeffs() = -rotation.coeffs();
    EXPECT_LT((toRotationVector(rotation) - vector).norm(), 1e-9);
  }
  EXPECT_EQ(toRotationVector(Quat::Identity()), Vec3::Zero());
  EXPECT_TRUE(fromRotationVector(Vec3::Zero()).isApprox(Quat::Identity()));
}

TEST(SeparateHeading, putsTheRotationTogetherAgain) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Quat rotation = fromEuler(
        kOrders[5], {Angle::radians(random.uniform(-3, 3)), Angle::radians(random.uniform(-1.5, 1.5)),
                     Angle::radians(random.uniform(-3, 3))});
    const auto [heading, tilt] = separateHeading(rotation);
    EXPECT_LT(angleBetween(heading.rotation() * tilt, rotation).radians(), 1e-7);
  }
}

TEST(SeparateHeading, isTheFirstAngleOfTheYxzOrder) {
  const Quat rotation = fromEuler({Axis::kY, Axis::kX, Axis::kZ},
                                  {Angle::degrees(130), Angle::degrees(20), Angle::degrees(-40)});
  const auto [heading, tilt] = separateHeading(rotation);
  EXPECT_NEAR(heading.angle().degrees(), 130.0, 1e-9);
  EXPECT_NEAR(toEuler({Axis::kY, Axis::kX, Axis::kZ}, tilt)[0].degrees(), 0.0, 1e-9);
}

TEST(HeadingOf, isTheHeadingThatIsSeparated) {
  Random random(6);
  for (int i = 0; i < 200; ++i) {
    const Quat rotation =
        fromRotationVector({random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)});
    EXPECT_EQ(headingOf(rotation).sin, separateHeading(rotation).heading.sin);
    EXPECT_EQ(headingOf(rotation).cos, separateHeading(rotation).heading.cos);
  }
}

}  // namespace
}  // namespace stridegraph
