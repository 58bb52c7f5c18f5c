#include "path/floor_plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "path/test_rooms.h"

namespace stridegraph {
namespace {

constexpr double kRadius = 0.4;

double bruteDistance(const Scene& scene, const Vec2& point) {
  double nearest =
      std::min({point.x(), point.y(), scene.widthMetres - point.x(), scene.depthMetres - point.y()});
  for (const Rectangle& rectangle : scene.obstacles) {
    const double dx = std::abs(point.x() - rectangle.centre.x()) - 0.5 * rectangle.size.x();
    const double dz = std::abs(point.y() - rectangle.centre.y()) - 0.5 * rectangle.size.y();
    const double outside = std::hypot(std::max(dx, 0.0), std::max(dz, 0.0));
    nearest = std::min(nearest, outside + std::min(std::max(dx, dz), 0.0));
  }
  return nearest;
}

TEST(FloorPlan, measuresDistancesToSidesCornersAndWalls) {
  const FloorPlan plan(roomWithOneBlock(), kRadius);
  EXPECT_DOUBLE_EQ(plan.distanceToNearest({3.0, 5.0}), 1.0);
  EXPECT_DOUBLE_EQ(plan.distanceToNearest({3.0, 3.0}), std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(plan.distanceToNearest({0.3, 5.0}), 0.3);
  EXPECT_DOUBLE_EQ(plan.distanceToNearest({4.5, 5.0}), -0.5);
  EXPECT_DOUBLE_EQ(plan.distanceToNearest({-0.25, 5.0}), -0.25);
  EXPECT_DOUBLE_EQ(plan.clearance({3.0, 5.0}), 0.6);
}

TEST(FloorPlan, letsTheDiscTouchButNotOverlap) {
  const FloorPlan plan(roomWithOneBlock(), kRadius);
  EXPECT_TRUE(plan.isFree({3.6, 5.0}));
  EXPECT_TRUE(plan.isFree({0.4, 0.4}));
  EXPECT_FALSE(plan.isFree({3.6 + 2e-6, 5.0}));
  EXPECT_FALSE(plan.isFree({0.4 - 2e-6, 5.0}));
  EXPECT_FALSE(plan.isFree({5.0, 5.0}));
}

TEST(FloorPlan, roundsTheCornersOfGrownRectangles) {
  const FloorPlan plan(roomWithOneBlock(), kRadius);
  const double side = kRadius / std::sqrt(2.0);
  EXPECT_TRUE(plan.isFree({4.0 - side - 1e-6, 4.0 - side - 1e-6}));
  EXPECT_FALSE(plan.isFree({4.0 - side + 1e-5, 4.0 - side + 1e-5}));
}

TEST(FloorPlan, refusesPlacesOutsideTheRoomAndWhatIsNoNumber) {
  const FloorPlan plan(emptyRoom(10.0, 10.0), kRadius);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(plan.isFree({-1.0, 5.0}));
  EXPECT_FALSE(plan.isFree({5.0, 11.0}));
  EXPECT_FALSE(plan.isFree({nan, 5.0}));
  EXPECT_FALSE(plan.isFree({5.0, nan}));
  EXPECT_FALSE(plan.isFree({5.0, 5.0}, {nan, 5.0}));
}

TEST(FloorPlan, refusesSegmentsThatCutACorner) {
  const FloorPlan plan(roomWithOneBlock(), kRadius);
  // The line x + z = 8 - c passes the corner (4, 4) at distance c / sqrt(2).
  const auto cut = [&](double distance) {
    const double c = distance * std::sqrt(2.0);
    return plan.isFree({2.0, 6.0 - c}, {6.0 - c, 2.0});
  };
  EXPECT_TRUE(cut(0.4 + 1e-5));
  EXPECT_FALSE(cut(0.4 - 1e-5));
  EXPECT_TRUE(plan.isFree({3.6, 1.0}, {3.6, 9.0}));
  EXPECT_FALSE(plan.isFree({3.61, 1.0}, {3.61, 9.0}));
  EXPECT_FALSE(plan.isFree({2.0, 5.0}, {8.0, 5.0}));
  EXPECT_FALSE(plan.isFree({2.0, 5.0}, {0.1, 5.0}));
}

TEST(FloorPlan, agreesWithBruteForceInRandomRooms) {
  Random random(11);
  for (int room = 0; room < 100; ++room) {
    const Scene scene = randomRoom(random, 40);
    const double radius = random.uniform(0.05, 1.5);
    const FloorPlan plan(scene, radius);
    for (int i = 0; i < 300; ++i) {
      const Vec2 point(random.uniform(-0.5, scene.widthMetres + 0.5),
                       random.uniform(-0.5, scene.depthMetres + 0.5));
      const double expected = bruteDistance(scene, point);
      ASSERT_NEAR(plan.distanceToNearest(point), expected, 1e-12);
      if (std::abs(expected - radius) > 1e-5) {
        ASSERT_EQ(plan.isFree(point), expected > radius);
      }
    }
  }
}

TEST(FloorPlan, segmentsAgreeWithDenseSamplesInRandomRooms) {
  Random random(12);
  int freeSegments = 0;
  for (int room = 0; room < 60; ++room) {
    const Scene scene = randomRoom(random, 25);
    const FloorPlan plan(scene, kRadius);
    for (int i = 0; i < 60; ++i) {
      const Vec2 from = randomPoint(random, scene);
      const Vec2 to = from + Vec2(random.uniform(-4.0, 4.0), random.uniform(-4.0, 4.0));
      double least = std::numeric_limits<double>::infinity();
      for (int k = 0; k <= 2000; ++k) {
        least = std::min(least, bruteDistance(scene, from + (k / 2000.0) * (to - from)));
      }
      // Samples are up to 3 mm apart: the true minimum lies at most 1.5 mm lower.
      if (std::abs(least - kRadius) < 0.0016) continue;
      ASSERT_EQ(plan.isFree(from, to), least > kRadius) << from.transpose() << " to " << to.transpose();
      freeSegments += plan.isFree(from, to) ? 1 : 0;
    }
  }
  EXPECT_GT(freeSegments, 300);
}

TEST(FloorPlan, handlesVastRoomsWithManyRectangles) {
  Random random(13);
  Scene scene = emptyRoom(300.0, 300.0);
  for (int i = 0; i < 2000; ++i) {
    const Vec2 centre = randomPoint(random, scene);
    scene.obstacles.push_back({centre, {random.uniform(0.3, 4.0), random.uniform(0.3, 4.0)}});
  }
  const FloorPlan plan(scene, kRadius);
  for (int i = 0; i < 500; ++i) {
    const Vec2 point = randomPoint(random, scene);
    const double expected = bruteDistance(scene, point);
    ASSERT_NEAR(plan.distanceToNearest(point), expected, 1e-12);
    if (std::abs(expected - kRadius) > 1e-5) {
      ASSERT_EQ(plan.isFree(point), expected > kRadius);
    }
  }
}

TEST(FloorPlan, survivesRectanglesThatCoverTheWholeRoomManyTimes) {
  Scene scene = emptyRoom(50.0, 50.0);
  for (int i = 0; i < 3000; ++i) scene.obstacles.push_back(rectangleAt(25.0, 25.0, 40.0 + 0.001 * i, 45.0));
  const FloorPlan plan(scene, kRadius);
  EXPECT_FALSE(plan.isFree({25.0, 25.0}));
  EXPECT_TRUE(plan.isFree({25.0, 1.0}));
  EXPECT_NEAR(plan.distanceToNearest({25.0, 2.0}), 0.5, 1e-12);
}

TEST(FloorPlan, findsTheBlockedPointsOfARow) {
  Random random(41);
  for (int room = 0; room < 30; ++room) {
    const Scene scene = randomRoom(random, 15);
    const FloorPlan plan(scene, 0.4);
    const double step = random.uniform(0.05, 0.4);
    // The last points lie beyond the room.
    std::vector<std::uint8_t> blocked(static_cast<std::size_t>(scene.widthMetres / step) + 2);
    for (double z = 0.0; z < scene.depthMetres + 0.5; z += 0.13) {
      plan.findBlocked(z, step, blocked);
      for (std::size_t i = 0; i < blocked.size(); ++i)
        EXPECT_EQ(blocked[i] == 0, plan.isFree(Vec2((static_cast<double>(i) + 0.5) * step, z)));
    }
  }
}

}  // namespace
}  // namespace stridegraph
