#include "scene/track.h"

#include <gtest/gtest.h>

namespace stridegraph {
namespace {

/// 2 m along x in the first two seconds, then 3 m along z in one.
MovingObstacle corner(TrackRepeat repeat, double firstSeconds = 0.0) {
  MovingObstacle obstacle;
  obstacle.size = {1.0, 0.5};
  obstacle.repeat = repeat;
  obstacle.track = {
      {firstSeconds, {1.0, 1.0}}, {firstSeconds + 2.0, {3.0, 1.0}}, {firstSeconds + 3.0, {3.0, 4.0}}};
  return obstacle;
}

TEST(Track, goesStraightAndEvenlyBetweenPoints) {
  for (const TrackRepeat repeat : {TrackRepeat::kLoop, TrackRepeat::kPingPong, TrackRepeat::kOnce}) {
    EXPECT_EQ(trackPosition(corner(repeat), 0.0), Vec2(1.0, 1.0));
    EXPECT_EQ(trackPosition(corner(repeat), 0.5), Vec2(1.5, 1.0));
    EXPECT_EQ(trackPosition(corner(repeat), 2.0), Vec2(3.0, 1.0));
    EXPECT_EQ(trackPosition(corner(repeat), 2.5), Vec2(3.0, 2.5));
  }
}

TEST(Track, waitsAtTheFirstPointUntilItsTime) {
  for (const TrackRepeat repeat : {TrackRepeat::kLoop, TrackRepeat::kPingPong, TrackRepeat::kOnce}) {
    EXPECT_EQ(trackPosition(corner(repeat, 4.0), 0.0), Vec2(1.0, 1.0));
    EXPECT_EQ(trackPosition(corner(repeat, 4.0), 3.9), Vec2(1.0, 1.0));
    EXPECT_EQ(trackPosition(corner(repeat, 4.0), 5.0), Vec2(2.0, 1.0));
    EXPECT_EQ(trackPosition(corner(repeat, -1.0), 0.0), Vec2(2.0, 1.0));
  }
}

TEST(Track, beginsAgainAtTheFirstPointWhenItLoops) {
  const MovingObstacle obstacle = corner(TrackRepeat::kLoop, 4.0);
  EXPECT_EQ(trackPosition(obstacle, 7.0), Vec2(1.0, 1.0));
  EXPECT_EQ(trackPosition(obstacle, 8.0), Vec2(2.0, 1.0));
  EXPECT_EQ(trackPosition(obstacle, 9.5), Vec2(3.0, 2.5));
  EXPECT_EQ(trackPosition(obstacle, 3008.0), Vec2(2.0, 1.0));
}

TEST(Track, goesBackAndForthWhenItIsPingPong) {
  const MovingObstacle obstacle = corner(TrackRepeat::kPingPong, 4.0);
  EXPECT_EQ(trackPosition(obstacle, 7.0), Vec2(3.0, 4.0));
  EXPECT_EQ(trackPosition(obstacle, 7.5), Vec2(3.0, 2.5));
  EXPECT_EQ(trackPosition(obstacle, 9.0), Vec2(2.0, 1.0));
  EXPECT_EQ(trackPosition(obstacle, 10.0), Vec2(1.0, 1.0));
  EXPECT_EQ(trackPosition(obstacle, 11.0), Vec2(2.0, 1.0));
  EXPECT_EQ(trackPosition(obstacle, 607.0), Vec2(3.0, 4.0));
}

TEST(Track, staysAtTheLastPointWhenItGoesOnce) {
  EXPECT_EQ(trackPosition(corner(TrackRepeat::kOnce, 0.1), 3.1), Vec2(3.0, 4.0));
  EXPECT_EQ(trackPosition(corner(TrackRepeat::kOnce, 0.1), 1e9), Vec2(3.0, 4.0));
}

TEST(Track, staysWhereItIsWithOnePoint) {
  for (const TrackRepeat repeat : {TrackRepeat::kLoop, TrackRepeat::kPingPong, TrackRepeat::kOnce}) {
    MovingObstacle obstacle = corner(repeat);
    obstacle.track.resize(1);
    EXPECT_EQ(trackPosition(obstacle, -3.0), Vec2(1.0, 1.0));
    EXPECT_EQ(trackPosition(obstacle, 7.0), Vec2(1.0, 1.0));
  }
}

TEST(Track, neverJumpsWhenItIsPingPong) {
  const MovingObstacle obstacle = corner(TrackRepeat::kPingPong, 0.3);
  Vec2 before = trackPosition(obstacle, 0.0);
  for (int i = 1; i < 3000; ++i) {
    const Vec2 now = trackPosition(obstacle, 0.01 * i);
    EXPECT_LE((now - before).norm(), 0.03 + 1e-9) << i;
    before = now;
  }
}

TEST(Track, givesTheFloorTheObstacleTakesUp) {
  const Rectangle there = rectangleAt(corner(TrackRepeat::kLoop), 1.0);
  EXPECT_EQ(there.centre, Vec2(2.0, 1.0));
  EXPECT_EQ(there.size, Vec2(1.0, 0.5));
}

}  // namespace
}  // namespace stridegraph
