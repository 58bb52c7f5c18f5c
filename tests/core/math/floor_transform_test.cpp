#include "math/floor_transform.h"

#include <gtest/gtest.h>

#include "math/random.h"

namespace stridegraph {
namespace {

FloorTransform randomTransform(Random& random) {
  return {{random.uniform(-5, 5), random.uniform(-5, 5)},
          Heading::fromAngle(Angle::radians(random.uniform(-3, 3)))};
}

TEST(Heading, facesPlusZAtZeroAndGrowsTowardsPlusX) {
  EXPECT_TRUE(Heading().direction().isApprox(Vec2(0, 1)));
  EXPECT_TRUE(Heading::fromAngle(Angle::degrees(90)).direction().isApprox(Vec2(1, 0), 1e-15));
}

TEST(Heading, fromAngleAgreesWithSineAndCosine) {
  for (int degrees = -720; degrees <= 720; degrees += 7) {
    const Angle angle = Angle::degrees(degrees);
    const Heading heading = Heading::fromAngle(angle);
    EXPECT_NEAR(heading.sin, std::sin(angle.radians()), 2e-15) << degrees;
    EXPECT_NEAR(heading.cos, std::cos(angle.radians()), 2e-15) << degrees;
  }
}

TEST(Heading, rotatesTheFloorAsItsQuaternionRotatesSpace) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Heading heading = randomTransform(random).heading;
    const Vec3 point(random.uniform(-1, 1), 0.3, random.uniform(-1, 1));
    const Vec3 turned = heading.rotation() * point;
    EXPECT_TRUE(onFloor(turned).isApprox(heading.rotate(onFloor(point)), 1e-12));
    EXPECT_NEAR(turned.y(), 0.3, 1e-12);
  }
}

TEST(Heading, sumAndDifferenceUndoEachOther) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Heading a = randomTransform(random).heading;
    const Heading b = randomTransform(random).heading;
    EXPECT_NEAR(((a + b) - b).angle().radians(), a.angle().radians(), 1e-12);
  }
}

TEST(Heading, blendDividesTheShorterArc) {
  const Heading from = Heading::fromAngle(Angle::degrees(175));
  const Heading to = Heading::fromAngle(Angle::degrees(-175));
  EXPECT_NEAR(std::abs(blend(from, to, 0.5).angle().degrees()), 180.0, 1e-9);
  const Heading quarter = blend(Heading(), Heading::fromAngle(Angle::radians(0.2)), 0.25);
  EXPECT_NEAR(quarter.angle().radians(), 0.05, 2e-4);
}

TEST(TurnFraction, risesEvenlyAsAHeadingTurnsOnce) {
  for (int k = 0; k < 720; ++k) {
    const double degrees = 0.5 * k;
    EXPECT_NEAR(turnFraction(Heading::fromAngle(Angle::degrees(degrees))), degrees / 360.0, 2e-5) << degrees;
  }
  EXPECT_LT(turnFraction(Heading{-1e-17, 1.0}), 1.0 + 1e-5);
}

TEST(FloorTransform, composesAndInverts) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const FloorTransform a = randomTransform(random);
    const FloorTransform b = randomTransform(random);
    const Vec2 point(random.uniform(-9, 9), random.uniform(-9, 9));
    EXPECT_TRUE(((a * b) * point).isApprox(a * (b * point), 1e-12));
    EXPECT_LT((a.inverse() * (a * point) - point).norm(), 1e-12);
  }
}

TEST(FloorTransform, appliesToSpaceWithoutTouchingHeight) {
  const FloorTransform transform{{1, 2}, Heading::fromAngle(Angle::degrees(90))};
  EXPECT_TRUE(transform.apply({0, 5, 1}).isApprox(Vec3(2, 5, 2), 1e-12));
}

}  // namespace
}  // namespace stridegraph
