#include "path/point_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "math/random.h"

namespace stridegraph {
namespace {

Vec2 randomPoint(Random& random) {
  const double x = random.uniform(0.0, 9.0);
  return {x, random.uniform(0.0, 7.0)};
}

PointGrid gridOf300(Random& random) {
  PointGrid grid({9.0, 7.0}, 0.8);
  for (int i = 0; i < 300; ++i) grid.add(randomPoint(random));
  return grid;
}

TEST(PointGrid, findsTheNearestAsBruteForceDoes) {
  Random random(41);
  const PointGrid grid = gridOf300(random);
  for (int i = 0; i < 100; ++i) {
    const Vec2 point = randomPoint(random);
    std::vector<std::pair<double, std::uint32_t>> all;
    for (std::uint32_t k = 0; k < 300; ++k) all.emplace_back((grid.points()[k] - point).squaredNorm(), k);
    std::sort(all.begin(), all.end());
    const std::vector<std::uint32_t> found = grid.nearest(point, 12);
    ASSERT_EQ(found.size(), 12U);
    for (std::size_t k = 0; k < found.size(); ++k) EXPECT_EQ(found[k], all[k].second);
  }
}

TEST(PointGrid, visitsAllPointsWithinADistanceOnce) {
  Random random(42);
  const PointGrid grid = gridOf300(random);
  for (int i = 0; i < 100; ++i) {
    const Vec2 point = randomPoint(random);
    const double metres = random.uniform(0.0, 3.0);
    std::vector<std::uint32_t> expected;
    for (std::uint32_t k = 0; k < 300; ++k)
      if ((grid.points()[k] - point).norm() < metres) expected.push_back(k);
    std::vector<std::uint32_t> found;
    grid.visitWithin(point, metres, [&](std::uint32_t index) { found.push_back(index); });
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
  }
}

TEST(PointGrid, breaksTiesByTheOrderOfAdding) {
  PointGrid grid({10.0, 10.0}, 1.0);
  for (const double x : {4.0, 6.0, 4.0}) grid.add({x, 5.0});
  EXPECT_EQ(grid.nearest({5.0, 5.0}, 3), (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(PointGrid, givesFewerWhenThereAreFewer) {
  PointGrid grid({10.0, 10.0}, 1.0);
  EXPECT_TRUE(grid.nearest({5.0, 5.0}, 3).empty());
  grid.add({1.0, 1.0});
  EXPECT_EQ(grid.nearest({9.0, 9.0}, 3).size(), 1U);
}

}  // namespace
}  // namespace stridegraph
