#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "math/random.h"
#include "scene/scene.h"

namespace stridegraph {

/// A number as people draw it (multiples of 1 cm) or as programs compute it.
inline double randomNumber(Random& random, double low, double high) {
  const double value = random.uniform(low, high);
  return random.below(2) == 0 ? value : std::round(value * 100.0) / 100.0;
}

inline Vec2 randomPair(Random& random, double low, double high) {
  const double x = randomNumber(random, low, high);
  return {x, randomNumber(random, low, high)};
}

inline std::optional<double> maybeNumber(Random& random, double low, double high) {
  if (random.below(2) == 0) return std::nullopt;
  return randomNumber(random, low, high);
}

inline WalkConstraints randomConstraints(Random& random) {
  WalkConstraints constraints;
  if (random.below(2) == 0) constraints.gait = random.below(2) == 0 ? Gait::kWalk : Gait::kRun;
  constraints.minSpeedMetresPerSecond = maybeNumber(random, 0.0, 2.0);
  constraints.maxSpeedMetresPerSecond = maybeNumber(random, 2.0, 10.0);
  constraints.latestArrivalSeconds = maybeNumber(random, 0.1, 3600.0);
  constraints.areas.resize(random.below(4));
  for (Area& area : constraints.areas) {
    area.rectangle = {randomPair(random, -5.0, 1005.0), randomPair(random, 0.1, 300.0)};
    area.kind = random.below(2) == 0 ? AreaKind::kAvoid : AreaKind::kPrefer;
  }
  return constraints;
}

/// A valid scene with something in every member; headings are such as JSON gives.
inline Scene randomScene(Random& random) {
  Scene scene;
  scene.name = random.below(4) == 0 ? ""
                                    : "H\xc3\xb6"
                                      "fe \"7\"\n";
  scene.widthMetres = randomNumber(random, 2.0, 1000.0);
  scene.depthMetres = randomNumber(random, 2.0, 1000.0);
  scene.obstacles.resize(random.below(20));
  for (Rectangle& obstacle : scene.obstacles) {
    obstacle = {randomPair(random, -5.0, 1005.0), randomPair(random, 0.1, 300.0)};
  }
  scene.moving.resize(random.below(3));
  for (MovingObstacle& moving : scene.moving) {
    moving.size = randomPair(random, 0.1, 3.0);
    moving.repeat = static_cast<TrackRepeat>(random.below(3));
    moving.track.resize(1 + random.below(4));
    double seconds = -1.0;
    for (TrackPoint& point : moving.track) {
      seconds += randomNumber(random, 0.1, 9.0);
      point = {seconds, randomPair(random, 0.0, 50.0)};
    }
  }
  scene.start.position = randomPair(random, -1.0, 1001.0);
  scene.goal.position = {-0.0, 1e-17};
  scene.start.heading = Angle::degrees(randomNumber(random, -400.0, 400.0));
  scene.walkers.resize(random.below(4));
  for (Walker& walker : scene.walkers) {
    walker.start.position = randomPair(random, 0.0, 50.0);
    walker.goal = {randomPair(random, 0.0, 50.0), Angle::degrees(randomNumber(random, -400.0, 400.0))};
  }
  if (random.below(2) == 0) scene.constraints = randomConstraints(random);
  scene.radiusMetres = randomNumber(random, 0.1, 5.0);
  scene.seed = random.bits();
  scene.unknownMembers = random.below(2) == 0 ? "" : R"({"note":"kept","list":[1,2.5,{}]})";
  return scene;
}

inline void expectSameRectangle(const Vec2& centre, const Vec2& size, const Rectangle& expected) {
  EXPECT_EQ(centre, expected.centre);
  EXPECT_EQ(size, expected.size);
}

inline void expectSameConstraints(const WalkConstraints& constraints, const WalkConstraints& expected) {
  EXPECT_EQ(constraints.gait, expected.gait);
  EXPECT_EQ(constraints.minSpeedMetresPerSecond, expected.minSpeedMetresPerSecond);
  EXPECT_EQ(constraints.maxSpeedMetresPerSecond, expected.maxSpeedMetresPerSecond);
  EXPECT_EQ(constraints.latestArrivalSeconds, expected.latestArrivalSeconds);
  ASSERT_EQ(constraints.areas.size(), expected.areas.size());
  for (std::size_t i = 0; i < constraints.areas.size(); ++i) {
    const Area& area = constraints.areas[i];
    expectSameRectangle(area.rectangle.centre, area.rectangle.size, expected.areas[i].rectangle);
    EXPECT_EQ(area.kind, expected.areas[i].kind);
  }
}

inline void expectSameScene(const Scene& scene, const Scene& expected) {
  EXPECT_EQ(scene.name, expected.name);
  EXPECT_EQ(scene.widthMetres, expected.widthMetres);
  EXPECT_EQ(scene.depthMetres, expected.depthMetres);
  ASSERT_EQ(scene.obstacles.size(), expected.obstacles.size());
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
    expectSameRectangle(scene.obstacles[i].centre, scene.obstacles[i].size, expected.obstacles[i]);
  }
  ASSERT_EQ(scene.moving.size(), expected.moving.size());
  for (std::size_t i = 0; i < scene.moving.size(); ++i) {
    EXPECT_EQ(scene.moving[i].size, expected.moving[i].size);
    EXPECT_EQ(scene.moving[i].repeat, expected.moving[i].repeat);
    ASSERT_EQ(scene.moving[i].track.size(), expected.moving[i].track.size());
    for (std::size_t k = 0; k < scene.moving[i].track.size(); ++k) {
      EXPECT_EQ(scene.moving[i].track[k].seconds, expected.moving[i].track[k].seconds);
      EXPECT_EQ(scene.moving[i].track[k].position, expected.moving[i].track[k].position);
    }
  }
  EXPECT_EQ(scene.start.position, expected.start.position);
  EXPECT_EQ(scene.start.heading, expected.start.heading);
  EXPECT_EQ(scene.goal.position, expected.goal.position);
  EXPECT_EQ(std::signbit(scene.goal.position.x()), std::signbit(expected.goal.position.x()));
  EXPECT_EQ(scene.goal.heading, expected.goal.heading);
  ASSERT_EQ(scene.walkers.size(), expected.walkers.size());
  for (std::size_t i = 0; i < scene.walkers.size(); ++i) {
    EXPECT_EQ(scene.walkers[i].start.position, expected.walkers[i].start.position);
    EXPECT_EQ(scene.walkers[i].start.heading, expected.walkers[i].start.heading);
    EXPECT_EQ(scene.walkers[i].goal.position, expected.walkers[i].goal.position);
    EXPECT_EQ(scene.walkers[i].goal.heading, expected.walkers[i].goal.heading);
  }
  expectSameConstraints(scene.constraints, expected.constraints);
  EXPECT_EQ(scene.radiusMetres, expected.radiusMetres);
  EXPECT_EQ(scene.seed, expected.seed);
  EXPECT_EQ(scene.unknownMembers, expected.unknownMembers);
}

}  // namespace stridegraph
