#include "ompl_bench/ompl_planners.h"

#include <gtest/gtest.h>

#include <atomic>

namespace stridegraph::bench {
namespace {

/// A room of 12 by 12 m with a block in the way, or a wall across it.
BenchRoom roomWith(const Rectangle& rectangle) {
  BenchRoom room{kMapsSet, "room", {}, {}};
  room.scene.start.position = {2, 6};
  room.scene.goal.position = {10, 6};
  room.scene.obstacles = {rectangle};
  return room;
}

/// A clock that is a little later whenever it is asked; OMPL's PRM asks from two threads.
MillisecondClock countingClock() {
  return [asked = std::make_shared<std::atomic<int>>(0)] { return 0.05 * ++*asked; };
}

MeasureParams measureParams() {
  MeasureParams params;
  params.clock = countingClock();
  return params;
}

TEST(OmplMethods, findFreePaths) {
  BenchRoom room = roomWith({{6, 6}, {1, 4}});
  room.shortestMetres = 8.0;
  std::vector<std::string> names;
  for (const PathMethod& method : omplMethods({.clock = countingClock()})) {
    names.push_back(method.name);
    const BenchRun run = measurePath(method, room, 1, measureParams());
    EXPECT_TRUE(isSound(run)) << method.name << ": " << run.status;
    EXPECT_GT(run.lengthMetres, 8.5) << method.name;
    EXPECT_LT(run.lengthMetres, 16.0) << method.name;
  }
  EXPECT_EQ(names, (std::vector<std::string>{"ompl-prm", "ompl-rrt-connect", "ompl-bit-star"}));
}

TEST(OmplMethods, stopWhenTheirTimeIsSpent) {
  const BenchRoom room = roomWith({{6, 6}, {0.4, 12}});
  for (const PathMethod& method : omplMethods({.mostMilliseconds = 50.0, .clock = countingClock()})) {
    const BenchRun run = measurePath(method, room, 1, measureParams());
    EXPECT_NE(run.status, "found") << method.name;
    EXPECT_EQ(run.lengthMetres, 0.0);
  }
}

}  // namespace
}  // namespace stridegraph::bench
