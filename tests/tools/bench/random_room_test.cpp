#include "bench/random_room.h"

#include <gtest/gtest.h>

#include <cmath>

#include "path/connectivity.h"
#include "path/floor_plan.h"
#include "scene/scene_json.h"

namespace stridegraph::bench {
namespace {

constexpr std::uint64_t kSeeds[] = {1, 7};
constexpr std::uint64_t kRooms = 40;

template <typename Check>
void forEachRoom(const Check& check) {
  for (const std::uint64_t seed : kSeeds) {
    for (std::uint64_t number = 1; number <= kRooms; ++number) {
      SCOPED_TRACE(::testing::Message() << "room " << number << " of " << seed);
      check(randomRoom(seed, number));
    }
  }
}

TEST(RandomRoom, isOfTheSizeAndClutterAskedFor) {
  double least = 1.0;
  double most = 0.0;
  forEachRoom([&](const Scene& room) {
    EXPECT_TRUE(checkScene(room).has_value());
    for (const double side : {room.widthMetres, room.depthMetres}) {
      EXPECT_GE(side, 12.0);
      EXPECT_LE(side, 40.0);
    }
    const double clutter = clutterOf(room);
    EXPECT_GE(clutter, 0.05);
    // The rectangle that reaches the share may be a block of 9 m2 in a room of 144.
    EXPECT_LE(clutter, 0.25 + 9.0 / 144.0);
    least = std::min(least, clutter);
    most = std::max(most, clutter);
  });
  EXPECT_LT(least, 0.08) << "the range is used";
  EXPECT_GT(most, 0.22) << "the range is used";
}

TEST(RandomRoom, hasEndsWithRoomToSpareAndAWayBetweenThem) {
  forEachRoom([](const Scene& room) {
    const FloorPlan plan(room, 0.65);
    EXPECT_GE(plan.clearance(room.start.position), -FloorPlan::kTouchToleranceMetres);
    EXPECT_GE(plan.clearance(room.goal.position), -FloorPlan::kTouchToleranceMetres);
    EXPECT_TRUE(isConnected(plan, room.start.position, room.goal.position));
    EXPECT_GE((room.goal.position - room.start.position).norm(),
              0.5 * std::hypot(room.widthMetres, room.depthMetres));
    EXPECT_TRUE(room.start.heading.has_value());
    EXPECT_FALSE(room.goal.heading.has_value());
    EXPECT_EQ(room.radiusMetres, 0.4);
  });
}

TEST(RandomRoom, isTheSameForTheSameNumbersAndAnotherForOthers) {
  const std::string room = writeSceneJson(randomRoom(7, 3));
  EXPECT_EQ(writeSceneJson(randomRoom(7, 3)), room);
  EXPECT_NE(writeSceneJson(randomRoom(7, 4)), room);
  EXPECT_NE(writeSceneJson(randomRoom(8, 3)), room);
  // Were numbers added to the seed, room 3 of 7 would be room 2 of 8.
  EXPECT_NE(randomRoom(8, 2).widthMetres, randomRoom(7, 3).widthMetres);
}

TEST(RandomRoom, comesBackFromItsText) {
  const Scene room = randomRoom(7, 5);
  const Result<Scene> back = readSceneJson(writeSceneJson(room));
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->start.position, room.start.position);
  EXPECT_EQ(back->start.heading->radians(), room.start.heading->radians());
  ASSERT_EQ(back->obstacles.size(), room.obstacles.size());
  for (std::size_t i = 0; i < room.obstacles.size(); ++i)
    EXPECT_EQ(back->obstacles[i].centre, room.obstacles[i].centre);
}

TEST(RandomRoom, holdsAsManyRectanglesAsAskedFor) {
  RandomRoomParams params;
  params.leastSideMetres = params.mostSideMetres = 50.0;
  params.mostBlockMetres = 1.5;
  params.mostWallMetres = 0.0;
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{100}}) {
    params.rectangles = count;
    const Scene room = randomRoom(1, 1, params);
    EXPECT_EQ(room.obstacles.size(), count);
    for (const Rectangle& rectangle : room.obstacles) EXPECT_LE(rectangle.size.maxCoeff(), 1.5);
  }
}

TEST(Clutter, isTheShareOfTheFloorUnderRectangles) {
  Scene room;
  room.widthMetres = 10.0;
  room.depthMetres = 8.0;
  EXPECT_EQ(clutterOf(room), 0.0);
  room.obstacles = {{{2, 2}, {2, 2}}};
  EXPECT_NEAR(clutterOf(room), 4.0 / 80.0, 1e-12);
  room.obstacles.push_back({{3, 2}, {2, 2}});
  EXPECT_NEAR(clutterOf(room), 6.0 / 80.0, 1e-12) << "what two cover counts once";
  room.obstacles = {{{10, 4}, {2, 20}}};
  EXPECT_NEAR(clutterOf(room), 8.0 / 80.0, 1e-12) << "what lies outside does not count";
}

}  // namespace
}  // namespace stridegraph::bench
