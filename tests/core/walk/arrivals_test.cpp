#include "walk/arrivals.h"

#include <gtest/gtest.h>

#include "walk/test_library.h"

namespace stridegraph {
namespace {

using testing::kStepMetres;

class Arrivals : public ::testing::Test {
 protected:
  MotionLibrary library = testing::threeArcsAndAStop();
  SearchGraph graph{library};
  ArrivalTable table{graph, WalkCost{}, library.frames.framesPerSecond, {}};

  /// Where the ways of an arrival lead, one after the other.
  FloorTransform endOf(std::uint32_t arrival) const {
    FloorTransform end;
    for (; table[arrival].next != Arrival::kNone; arrival = table[arrival].next)
      end = end * graph.edges()[table[arrival].edge].end;
    return end * graph.edges()[table[arrival].edge].settledEnd;
  }
};

TEST_F(Arrivals, areNoneWhereNobodyStands) {
  const MotionLibrary restless = testing::threeArcs();
  const SearchGraph restlessGraph(restless);
  const ArrivalTable empty(restlessGraph, WalkCost{}, 30.0, {});
  EXPECT_EQ(empty.size(), 0U);
  EXPECT_EQ(empty.leastMetres(0), 4.0);
}

TEST_F(Arrivals, lieWhereTheirWaysLead) {
  ASSERT_GE(table.size(), 4U);
  for (std::uint32_t a = 0; a < table.size(); ++a) {
    const FloorTransform end = endOf(a);
    EXPECT_LT((end.translation - table[a].end.translation).norm(), 1e-9);
    EXPECT_NEAR((end.heading - table[a].end.heading).cos, 1.0, 1e-9);
  }
}

TEST_F(Arrivals, areFoundFromTheNodeByTheirPlace) {
  // From the straight clip's end, the stop is 12 frames of blend and 13 more of going away, all straight on.
  const Vec2 stop(0.0, 25 * kStepMetres);
  const std::vector<std::uint32_t> found = table.near(0, stop, 0.02);
  ASSERT_FALSE(found.empty());
  EXPECT_LT((table[found.front()].end.translation - stop).norm(), 0.02);
  EXPECT_EQ(table[found.front()].next, Arrival::kNone);
  EXPECT_TRUE(table.near(0, {-3.0, -3.0}, 0.02).empty());
}

TEST_F(Arrivals, costNoLessThanTheLeastOfTheirNode) {
  for (std::uint32_t node = 0; node < graph.nodeCount(); ++node) {
    for (const std::uint32_t a : table.near(node, {0.0, 0.0}, 10.0)) {
      EXPECT_GE(table[a].costMetres, table.leastMetres(node));
    }
  }
}

TEST_F(Arrivals, areTheCheapestOfEveryNodeWhereThereAreMore) {
  ArrivalTable::Params params;
  params.mostOfNode = 1;
  const ArrivalTable few(graph, WalkCost{}, library.frames.framesPerSecond, params);
  EXPECT_LT(few.size(), table.size());
  for (std::uint32_t node = 0; node < graph.nodeCount(); ++node) {
    const std::vector<std::uint32_t> found = few.near(node, {0.0, 0.0}, 10.0);
    ASSERT_EQ(found.size(), table.near(node, {0.0, 0.0}, 10.0).empty() ? 0U : 1U);
    EXPECT_EQ(few.leastMetres(node), table.leastMetres(node));
    for (const std::uint32_t a : found) EXPECT_EQ(few[a].costMetres, table.leastMetres(node));
  }
}

}  // namespace
}  // namespace stridegraph
