#include "path/polyline.h"

#include <gtest/gtest.h>

namespace stridegraph {
namespace {

const std::vector<Vec2> kCornerPath = {{0.0, 0.0}, {3.0, 0.0}, {3.0, 4.0}};

TEST(Polyline, addsUpItsSegments) {
  EXPECT_DOUBLE_EQ(polylineLength(kCornerPath), 7.0);
  EXPECT_EQ(polylineLength({}), 0.0);
}

TEST(Polyline, findsPointsByArcLengthAndClampsToItsEnds) {
  EXPECT_EQ(pointAtLength(kCornerPath, 1.0), Vec2(1.0, 0.0));
  EXPECT_EQ(pointAtLength(kCornerPath, 5.0), Vec2(3.0, 2.0));
  EXPECT_EQ(pointAtLength(kCornerPath, -1.0), Vec2(0.0, 0.0));
  EXPECT_EQ(pointAtLength(kCornerPath, 99.0), Vec2(3.0, 4.0));
}

TEST(Polyline, spacesSubgoalsEvenlyAndEndsAtTheGoal) {
  const std::vector<Vec2> points = subgoals(kCornerPath, 2.0);
  ASSERT_EQ(points.size(), 4U);
  EXPECT_TRUE(points[0].isApprox(Vec2(1.75, 0.0)));
  EXPECT_TRUE(points[1].isApprox(Vec2(3.0, 0.5)));
  EXPECT_EQ(points[3], kCornerPath.back());
}

TEST(Polyline, givesOneSubgoalForAShortPathAndNoneForAnEmptyOne) {
  EXPECT_EQ(subgoals(kCornerPath, 100.0), std::vector<Vec2>{kCornerPath.back()});
  EXPECT_EQ(subgoals(std::vector<Vec2>{{1.0, 1.0}, {1.0, 1.0}}, 2.0), (std::vector<Vec2>{{1.0, 1.0}}));
  EXPECT_TRUE(subgoals({}, 2.0).empty());
}

TEST(Polyline, dropsRepeatedPoints) {
  const std::vector<Vec2> path = {{0.0, 0.0}, {0.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}, {0.0, 0.0}};
  EXPECT_EQ(withoutRepeats(path), (std::vector<Vec2>{{0.0, 0.0}, {1.0, 0.0}, {0.0, 0.0}}));
}

}  // namespace
}  // namespace stridegraph
