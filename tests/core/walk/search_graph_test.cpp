#include "walk/search_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "walk/test_gait_library.h"
#include "walk/test_library.h"

namespace stridegraph {
namespace {

using testing::threeArcs;
using testing::threeArcsAndAStart;
using testing::threeArcsAndAStop;

TEST(SearchGraph, keepsOnlyNodesWithAChoice) {
  const SearchGraph graph(threeArcs());
  ASSERT_EQ(graph.nodeCount(), 3U);
  // Three ways on from each, as captured and bent to either side.
  for (std::size_t node = 0; node < graph.nodeCount(); ++node) EXPECT_EQ(graph.edgesFrom(node).size(), 9U);
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

TEST(SearchGraph, bentWaysPlayTheSameFramesAndTurnFurtherWithEveryMetre) {
  MotionLibrary library = threeArcs();
  library.frames.framesPerSecond = 20.0;  // 1 m/s: not so fast that it is bent less.
  const SearchGraph graph(library);
  for (std::size_t node = 0; node < graph.nodeCount(); ++node) {
    const auto ways = graph.edgesFrom(node);
    for (std::size_t way = 0; way < ways.size(); way += 3) {
      const SearchEdge& captured = ways[way];
      EXPECT_EQ(captured.bendRadians, 0.0);
      for (const int side : {1, -1}) {
        const SearchEdge& bent = ways[side > 0 ? way + 1 : way + 2];
        EXPECT_EQ(bent.to, captured.to);
        EXPECT_EQ(bent.sampleCount, captured.sampleCount);
        EXPECT_NEAR(bent.lengthMetres, captured.lengthMetres, 1e-9);
        const double added = (bent.end.heading - captured.end.heading).angle().degrees();
        EXPECT_NEAR(added, side * 60.0 * captured.lengthMetres, 1e-6);
        EXPECT_NEAR(bent.bendRadians, std::abs(Angle::degrees(added).radians()), 1e-9);
      }
    }
  }
}

TEST(SearchGraph, bendsNoWayThatEndsTheWalk) {
  const SearchGraph graph(threeArcsAndAStop());
  for (const SearchEdge& way : graph.edges()) {
    EXPECT_TRUE(way.to != SearchEdge::kNone || way.bendRadians == 0.0);
  }
}

TEST(SearchGraph, bendsFastGaitsLess) {
  MotionLibrary library = threeArcs();
  library.frames.framesPerSecond = 60.0;
  const SearchGraph graph(library);
  const SearchEdge& captured = graph.edgesFrom(0)[0];
  // 3 m/s: 1.5 m/s2 there are a curve of 6 m.
  EXPECT_NEAR(graph.edgesFrom(0)[1].bendRadians, captured.lengthMetres / 6.0, 1e-9);
}

TEST(SearchGraph, offersEveryEighthMovingFrameAsAStartBentToEitherSide) {
  const SearchGraph graph(threeArcs());
  // There are 12 on each of three pieces from frame 14 on, and 14 on the runs in from frame 0.
  ASSERT_EQ(graph.starts().size(), 10U * 3U);
  const SearchEdge& second = graph.starts()[3].edge;
  EXPECT_EQ(graph.stepsOf(second)[0].piece.from.value, 14U);
  EXPECT_EQ(graph.stepsOf(second)[0].begin, 8U);
  EXPECT_EQ(second.sampleCount, 4U);
  EXPECT_EQ(second.bendRadians, 0.0);
  for (const std::size_t bent : {4U, 5U}) {
    EXPECT_EQ(graph.stepsOf(graph.starts()[bent].edge)[0].begin, 8U);
    EXPECT_GT(graph.starts()[bent].edge.bendRadians, 0.0);
  }
  // The sixth is the fifth frame of the first run in, before the first node of its clip.
  const SearchEdge& runIn = graph.starts()[15].edge;
  EXPECT_EQ(graph.stepsOf(runIn)[0].piece.from.value, 0U);
  EXPECT_EQ(graph.stepsOf(runIn)[0].piece.to.value, 14U);
  EXPECT_EQ(runIn.sampleCount, 10U + 12U);
}

TEST(SearchGraph, ofBodiesThatNeverStandHasNoStandingEnds) {
  const SearchGraph graph(threeArcs());
  EXPECT_FALSE(graph.canStartStanding());
  EXPECT_FALSE(graph.canEndStanding());
}

TEST(SearchGraph, runsOutBehindTheLastNodeToWhereTheBodyHasStood) {
  const SearchGraph graph(threeArcsAndAStop());
  EXPECT_TRUE(graph.canEndStanding());
  // Of the stop, which comes to a stand at frame 29 of its clip and has settled 8 frames later.
  const auto edges = graph.edges();
  const auto stop = std::find_if(edges.begin(), edges.end(),
                                 [](const SearchEdge& edge) { return edge.to == SearchEdge::kNone; });
  ASSERT_NE(stop, edges.end());
  EXPECT_EQ(stop->settledSample + 1, stop->sampleCount);
  EXPECT_TRUE(stop->settledEnd.translation.isApprox(stop->end.translation, 1e-9));
  EXPECT_EQ(graph.stepsOf(*stop).back().piece.from.value, 3U * testing::kClipFrames + 14U);
}

TEST(SearchGraph, startsFromAStandJustBeforeTheBodyMoves) {
  const SearchGraph graph(threeArcsAndAStart());
  EXPECT_TRUE(graph.canStartStanding());
  std::size_t standing = 0;
  for (const SearchStart& start : graph.starts()) {
    if (!start.stands) continue;
    ++standing;
    EXPECT_LT(graph.stepsOf(start.edge).front().begin, 10U);
    EXPECT_GE(graph.stepsOf(start.edge).front().begin, 2U);
  }
  // As captured and bent to either side.
  EXPECT_EQ(standing, 3U);
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

TEST(SearchGraph, hasWaysThroughEveryClipOfTheDefaultLibrary) {
  const MotionLibrary& library = testing::gaitPlanner().library();
  for (const LibraryClip& clip : library.clips) {
    const auto lies = [&clip](FrameIndex node) {
      return node.value >= clip.firstFrame && node.value < clip.firstFrame + clip.frameCount;
    };
    EXPECT_TRUE(std::any_of(library.graph.nodes.begin(), library.graph.nodes.end(), lies)) << clip.name;
  }
}

}  // namespace
}  // namespace stridegraph
