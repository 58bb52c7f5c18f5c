#include "walk/traffic.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <vector>

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

TEST(Traffic, tellsWhenAnObstacleFirstTouchesWhoStays) {
  Traffic traffic(kRadius, 30.0);
  traffic.addObstacle(shuttle());
  // Its edge comes to within 0.4 m of (2.51, 0) when its middle is at 1.61, and again on its way back.
  EXPECT_EQ(traffic.touchedFrom({2.51, 0.0}, 0), 49U);
  EXPECT_EQ(traffic.touchedFrom({2.51, 0.0}, 60), 60U);
  EXPECT_EQ(traffic.touchedFrom({-0.01, 0.0}, 60), 154U);
  EXPECT_EQ(traffic.touchedFrom({1.0, 3.0}, 0), std::nullopt);
  const std::array<Vec2, 1> body = {Vec2(1, 3)};
  traffic.addBody(body);
  EXPECT_EQ(traffic.touchedFrom({1.0, 3.0}, 0), std::nullopt);
}

TEST(Traffic, looksAlongAWholeTrackForATouchThatComesLate) {
  Traffic once(kRadius, 30.0);
  once.addObstacle({{1.0, 1.0}, TrackRepeat::kOnce, {{0.0, {0, 0}}, {100.0, {0, 0}}, {103.0, {3, 0}}}});
  EXPECT_EQ(once.touchedFrom({3.01, 0.0}, 0), 3000U + 64U);
  EXPECT_EQ(once.touchedFrom({0.0, 0.0}, 4000), std::nullopt);
  Traffic again(kRadius, 30.0);
  again.addObstacle({{1.0, 1.0}, TrackRepeat::kLoop, {{10.0, {0, 0}}, {12.0, {4, 0}}}});
  // Each loop begins where the last has begun, after 2 s.
  EXPECT_EQ(again.touchedFrom({0.0, 0.0}, 320), 360U);
}

TEST(Traffic, knowsWhetherSomebodyComesOverWhoStays) {
  Traffic traffic(kRadius, 30.0);
  traffic.addObstacle(shuttle());
  std::vector<Vec2> way;
  for (int f = 0; f <= 100; ++f) way.emplace_back(0.05 * f, 8.0);
  traffic.addBody(way);
  traffic.addBody(way, 50);
  EXPECT_FALSE(traffic.staysClearOfBodies({2.0, 8.5}, 0));
  EXPECT_FALSE(traffic.staysClearOfBodies({2.0, 8.5}, 50));
  EXPECT_TRUE(traffic.staysClearOfBodies({2.0, 8.5}, 56));
  EXPECT_FALSE(traffic.staysClearOfBodies({5.0, 8.5}, Traffic::kInTheEnd));
  EXPECT_TRUE(traffic.staysClearOfBodies({1.0, 0.0}, 0));
}

TEST(Traffic, knowsWhetherAPlaceIsEverFree) {
  Traffic traffic(kRadius, 30.0);
  traffic.addObstacle({{1.0, 1.0}, TrackRepeat::kOnce, {{0.0, {3, 0}}, {3.0, {0, 0}}}});
  EXPECT_FALSE(traffic.isNeverFree({0, 0}, 0.0, 0));
  EXPECT_TRUE(traffic.isNeverFree({0, 0}, 0.0, 90));
  EXPECT_FALSE(traffic.isNeverFree({3, 0}, 0.0, 90));
  Traffic nothing(kRadius, 30.0);
  EXPECT_FALSE(nothing.isNeverFree({0, 0}, 0.0, 0));
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
