#include "walk/traffic.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "math/random.h"

namespace stridegraph {
namespace {

constexpr double kRadius = 0.4;

/// A box of 1 m that goes from (0, 0) to (3, 0) within three seconds, and back.
MovingObstacle shuttle() {
  return {{1.0, 1.0}, TrackRepeat::kPingPong, {{0.0, {0, 0}}, {3.0, {3, 0}}}};
}

TEST(Traffic, isNowhereWhenNothingMoves) {
  Traffic traffic(kRadius, 30.0);
  EXPECT_TRUE(traffic.empty());
  EXPECT_TRUE(std::isinf(traffic.clearance({0, 0}, 7)));
}

TEST(Traffic, measuresToABoxWhereItIsThen) {
  Traffic traffic(kRadius, 30.0);
  traffic.addObstacle(shuttle());
  // After a second its middle is at (1, 0), its edge at 1.5.
  EXPECT_NEAR(traffic.clearance({2.5, 0.0}, 30), 1.0 - kRadius, 1e-9);
  EXPECT_NEAR(traffic.clearance({2.5, 0.0}, 90), -kRadius, 1e-9);
  EXPECT_NEAR(traffic.clearance({2.5, 0.0}, 150), 1.0 - kRadius, 1e-9);
  EXPECT_NEAR(traffic.clearance({1.5 + 3.0, 0.5 + 4.0}, 30), 5.0 - kRadius, 1e-9);
}

TEST(Traffic, keepsABodyWhereItsWayEndsAndForgetsItWhenItIsGone) {
  Traffic traffic(kRadius, 30.0);
  const std::array<Vec2, 2> way = {Vec2(0, 0), Vec2(0.1, 0)};
  traffic.addBody(way, 50);
  EXPECT_NEAR(traffic.clearance({1.1, 0.0}, 1), 0.2, 1e-9);
  EXPECT_NEAR(traffic.clearance({1.1, 0.0}, 49), 0.2, 1e-9);
  EXPECT_TRUE(std::isinf(traffic.clearance({1.1, 0.0}, 50)));
}

TEST(Traffic, stopsAWayExactlyWhereASampleComesTooNear) {
  Random random(3);
  Traffic traffic(kRadius, 30.0);
  traffic.addObstacle(shuttle());
  traffic.addObstacle({{0.6, 2.0}, TrackRepeat::kLoop, {{0.5, {-4, -4}}, {2.5, {4, 4}}}});
  const std::array<Vec2, 3> body = {Vec2(1, 3), Vec2(1.1, 3), Vec2(1.2, 3)};
  traffic.addBody(body);
  int stopped = 0;
  for (int i = 0; i < 2000; ++i) {
    const FloorTransform from{{random.uniform(-5, 5), random.uniform(-5, 5)},
                              Heading::fromAngle(Angle::degrees(random.uniform(0, 360)))};
    const auto frame = static_cast<std::uint32_t>(random.uniform(0, 400));
    std::array<Eigen::Vector2f, 9> samples;
    bool touches = false;
    for (std::uint32_t s = 0; s < samples.size(); ++s) {
      samples[s] = {0.0F, 0.06F * static_cast<float>(s)};
      const Vec2 point = from * Vec2(samples[s].cast<double>());
      touches = touches || traffic.clearance(point, frame + s) < Traffic::kMarginMetres;
    }
    EXPECT_EQ(traffic.isFree(from, samples, frame), !touches);
    stopped += touches ? 1 : 0;
  }
  EXPECT_GT(stopped, 100);
  EXPECT_LT(stopped, 1900);
}

}  // namespace
}  // namespace stridegraph
