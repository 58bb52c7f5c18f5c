#include "walk/search_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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

/// The ways of a graph that play the same frames as a captured one, bent to the left and to the right.
std::array<const SearchEdge*, 2> bentLike(const SearchGraph& graph, std::size_t node,
                                          const SearchEdge& captured) {
  std::array<const SearchEdge*, 2> bent{};
  for (const SearchEdge& way : graph.edgesFrom(node)) {
    if (way.bendRadians == 0.0 || way.to != captured.to || way.stepCount != captured.stepCount) continue;
    const bool left = graph.stepsOf(way).front().turnPerMetre > Angle{};
    bent[left ? 0 : 1] = &way;
  }
  return bent;
}

TEST(SearchGraph, bentWaysPlayTheSameFramesAndTurnFurtherWithEveryMetre) {
  MotionLibrary library = threeArcs();
  library.frames.framesPerSecond = 20.0;  // 1 m/s: not so fast that it is bent less.
  const SearchGraph graph(library);
  std::size_t seen = 0;
  for (std::size_t node = 0; node < graph.nodeCount(); ++node) {
    for (const SearchEdge& captured : graph.edgesFrom(node)) {
      if (captured.bendRadians > 0.0) continue;
      ++seen;
      double degrees = 60.0 * captured.lengthMetres;
      for (const SearchEdge* bent : bentLike(graph, node, captured)) {
        ASSERT_NE(bent, nullptr);
        EXPECT_EQ(bent->sampleCount, captured.sampleCount);
        EXPECT_NEAR(bent->lengthMetres, captured.lengthMetres, 1e-9);
        const double added = (bent->end.heading - captured.end.heading).angle().degrees();
        EXPECT_NEAR(added, degrees, 1e-6);
        EXPECT_NEAR(bent->bendRadians, std::abs(Angle::degrees(added).radians()), 1e-9);
        degrees = -degrees;
      }
    }
  }
  EXPECT_EQ(seen, 9U);
}

TEST(SearchGraph, usuallyBendsNoTransitionWhereAnythingElseIsBent) {
  const SearchGraph graph(testing::gaitPlanner().library());
  std::size_t rare = 0;
  for (std::size_t node = 0; node < graph.nodeCount(); ++node) {
    const auto usual = graph.usualEdgesFrom(node);
    const auto all = graph.edgesFrom(node);
    ASSERT_EQ(usual.data(), all.data());
    const bool bendsOthers = std::any_of(all.begin(), all.end(), [](const SearchEdge& way) {
      return way.bendRadians > 0.0 && way.transitions == 0;
    });
    for (std::size_t way = 0; way < all.size(); ++way) {
      const bool bentTransition = all[way].bendRadians > 0.0 && all[way].transitions > 0;
      EXPECT_EQ(way >= usual.size(), bendsOthers && bentTransition);
    }
    rare += all.size() - usual.size();
  }
  EXPECT_GT(rare, 0U);
}

TEST(SearchGraph, usuallyBeginsInHalfOfTheMovingFrames) {
  const SearchGraph graph(testing::gaitPlanner().library());
  const auto countOf = [](std::span<const SearchStart> starts, bool standing) {
    return std::count_if(starts.begin(), starts.end(),
                         [&](const SearchStart& start) { return start.stands == standing; });
  };
  EXPECT_EQ(graph.usualStarts().data(), graph.starts().data());
  EXPECT_EQ(countOf(graph.usualStarts(), true), countOf(graph.starts(), true));
  const double share = static_cast<double>(countOf(graph.usualStarts(), false)) /
                       static_cast<double>(countOf(graph.starts(), false));
  EXPECT_NEAR(share, 0.5, 0.01);
}

TEST(SearchGraph, knowsItsWaysFromBothEnds) {
  const SearchGraph graph(testing::gaitPlanner().library());
  std::size_t into = 0;
  for (std::uint32_t node = 0; node < graph.nodeCount(); ++node) {
    for (const SearchEdge& way : graph.edgesFrom(node)) EXPECT_EQ(way.from, node);
    for (const std::uint32_t way : graph.edgesInto(node)) EXPECT_EQ(graph.edges()[way].to, node);
    into += graph.edgesInto(node).size();
  }
  const auto leadsOn = [](const SearchEdge& way) { return way.to != SearchEdge::kNone; };
  EXPECT_EQ(into,
            static_cast<std::size_t>(std::count_if(graph.edges().begin(), graph.edges().end(), leadsOn)));
  for (const SearchStart& start : graph.starts()) EXPECT_EQ(start.edge.from, SearchEdge::kNone);
}

TEST(SearchGraph, bendsTransitionsWhereThereIsNothingElse) {
  const SearchGraph graph(threeArcs());
  EXPECT_EQ(graph.usualEdgesFrom(0).size(), graph.edgesFrom(0).size());
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
  EXPECT_NEAR(bentLike(graph, 0, captured)[0]->bendRadians, captured.lengthMetres / 6.0, 1e-9);
}

TEST(SearchGraph, offersEveryEighthMovingFrameAsAStartBentToEitherSide) {
  const SearchGraph graph(threeArcs());
  // There are 12 on each of three pieces from frame 14 on, and 14 on the runs in from frame 0.
  ASSERT_EQ(graph.starts().size(), 10U * 3U);
  // Every other one is usual, and those come first.
  ASSERT_EQ(graph.usualStarts().size(), 5U * 3U);
  const SearchEdge& second = graph.starts()[15].edge;
  EXPECT_EQ(graph.stepsOf(second)[0].piece.from.value, 14U);
  EXPECT_EQ(graph.stepsOf(second)[0].begin, 8U);
  EXPECT_EQ(second.sampleCount, 4U);
  EXPECT_EQ(second.bendRadians, 0.0);
  for (const std::size_t bent : {16U, 17U}) {
    EXPECT_EQ(graph.stepsOf(graph.starts()[bent].edge)[0].begin, 8U);
    EXPECT_GT(graph.starts()[bent].edge.bendRadians, 0.0);
  }
  // The sixth is the fifth frame of the first run in, before the first node of its clip.
  const SearchEdge& runIn = graph.starts()[21].edge;
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
