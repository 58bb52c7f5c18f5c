#include "state/track_edit.h"

#include <gtest/gtest.h>

namespace stridegraph {
namespace {

/// 2 m in 1 s, a wait of 2 s, 4 m in 1 s.
MovingObstacle withWait() {
  MovingObstacle obstacle;
  obstacle.track = {{1.0, {1.0, 1.0}}, {2.0, {3.0, 1.0}}, {4.0, {3.0, 1.0}}, {5.0, {3.0, 5.0}}};
  return obstacle;
}

TEST(TrackEdit, makesATwoPointWayOfASpeed) {
  const MovingObstacle moving = backAndForth({Vec2(1.0, 1.0), Vec2(2.0, 0.5)}, Vec2(4.0, 5.0), 0.5);
  EXPECT_EQ(moving.size, Vec2(2.0, 0.5));
  EXPECT_EQ(moving.repeat, TrackRepeat::kPingPong);
  EXPECT_EQ(moving.track[1].seconds, 10.0);
  EXPECT_NEAR(trackSpeed(moving), 0.5, 1e-12);
}

TEST(TrackEdit, keepsTimesGrowingWhereThereIsNoWay) {
  const MovingObstacle still = backAndForth({Vec2(1.0, 1.0), Vec2::Ones()}, Vec2(1.0, 1.0), 0.5);
  EXPECT_GT(still.track[1].seconds, still.track[0].seconds);
  EXPECT_EQ(trackSpeed(still), 0.0);
  EXPECT_EQ(withTrackSpeed(still, 2.0).track[1].seconds, still.track[1].seconds);
}

TEST(TrackEdit, setsTheSpeedOfTheWholeWay) {
  EXPECT_NEAR(trackSpeed(withWait()), 6.0 / 4.0, 1e-12);
  const MovingObstacle slow = withTrackSpeed(withWait(), 0.75);
  EXPECT_NEAR(trackSpeed(slow), 0.75, 1e-9);
  EXPECT_EQ(slow.track[0].seconds, 1.0);
  EXPECT_NEAR(slow.track[2].seconds - slow.track[1].seconds, 4.0, 1e-9);
}

TEST(TrackEdit, keepsSpeedsAndWaitsWhenAPointMoves) {
  const MovingObstacle moved = withTrackPoint(withWait(), 3, {3.0, 3.0});
  EXPECT_EQ(moved.track[2].seconds, 4.0);
  EXPECT_NEAR(moved.track[3].seconds, 4.5, 1e-9);
}

TEST(TrackEdit, movesATrackNoFartherThanTheRoomAllows) {
  const MovingObstacle moved = withTrackMoved(withWait(), {-9.0, 1.0}, {10.0, 8.0});
  EXPECT_EQ(moved.track[0].position, Vec2(0.0, 2.0));
  EXPECT_EQ(moved.track[3].position, Vec2(2.0, 6.0));
}

TEST(TrackEdit, makesABlockMoveToWhereTheRoomIsAndStandAgain) {
  Scene scene;
  scene.widthMetres = 10.0;
  scene.depthMetres = 6.0;
  scene.obstacles = {{Vec2(1.0, 1.0), Vec2::Ones()}, {Vec2(8.0, 3.0), Vec2(2.0, 1.0)}};
  const Scene moving = withBlockMoving(scene, 1);
  ASSERT_EQ(moving.obstacles.size(), 1u);
  ASSERT_EQ(moving.moving.size(), 1u);
  EXPECT_EQ(moving.moving[0].track[0].position, Vec2(8.0, 3.0));
  EXPECT_EQ(moving.moving[0].track[1].position, Vec2(5.0, 3.0));
  const Scene standing = withBlockStanding(moving, 0);
  EXPECT_TRUE(standing.moving.empty());
  EXPECT_EQ(standing.obstacles.back().centre, Vec2(8.0, 3.0));
  EXPECT_EQ(standing.obstacles.back().size, Vec2(2.0, 1.0));
}

}  // namespace
}  // namespace stridegraph
