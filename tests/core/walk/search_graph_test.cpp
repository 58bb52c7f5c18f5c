#include "walk/search_graph.h"

#include <gtest/gtest.h>

#include "walk/test_library.h"

namespace stridegraph {
namespace {

using testing::threeArcs;

TEST(SearchGraph, keepsOnlyNodesWithAChoice) {
  const SearchGraph graph(threeArcs());
  ASSERT_EQ(graph.nodeCount(), 3U);
  for (std::size_t node = 0; node < graph.nodeCount(); ++node) EXPECT_EQ(graph.edgesFrom(node).size(), 3U);
}

TEST(SearchGraph, waysRunThroughNodesWithoutAChoice) {
  const SearchGraph graph(threeArcs());
  const SearchEdge& way = graph.edgesFrom(0)[0];
  EXPECT_EQ(way.sampleCount, 24U);
  EXPECT_EQ(graph.stepsOf(way).size(), 2U);
  EXPECT_EQ(way.transitions, 1U);
  EXPECT_NEAR(way.transitionDistanceMetres, 0.02, 1e-6);
  EXPECT_NEAR(way.lengthMetres, 24 * testing::kStepMetres, 1e-6);
}

TEST(SearchGraph, samplesEndWhereTheWayEnds) {
  const SearchGraph graph(threeArcs());
  for (std::size_t node = 0; node < graph.nodeCount(); ++node) {
    for (const SearchEdge& way : graph.edgesFrom(node)) {
      EXPECT_LT((graph.samplesOf(way).back().cast<double>() - way.end.translation).norm(), 1e-5);
    }
  }
}

TEST(SearchGraph, offersEverySecondCapturedFrameAsAStart) {
  const SearchGraph graph(threeArcs());
  ASSERT_EQ(graph.starts().size(), 3U * 6U);
  const SearchEdge& second = graph.starts()[1];
  EXPECT_EQ(graph.stepsOf(second)[0].begin, 2U);
  EXPECT_EQ(second.sampleCount, 10U);
}

TEST(SearchGraph, ofASingleLoopHasOneNode) {
  MotionLibrary library = threeArcs();
  library.graph.nodes.resize(2);
  library.graph.edges = {library.graph.edges[0], library.graph.edges[1]};
  library.graph.firstEdge = {0, 1, 2};
  const SearchGraph graph(library);
  ASSERT_EQ(graph.nodeCount(), 1U);
  EXPECT_EQ(graph.edgesFrom(0)[0].sampleCount, 24U);
}

}  // namespace
}  // namespace stridegraph
