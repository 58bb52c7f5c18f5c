#include "graph/graph_building.h"

#include <gtest/gtest.h>

#include "math/random.h"

namespace stridegraph {
namespace {

FrameIndex frame(std::size_t index) {
  return FrameIndex(index);
}

FrameTransition jump(std::size_t from, std::size_t to) {
  return {frame(from), frame(to), 12, 12, 12, 0.01F};
}

/// Two clips of 100 frames with transitions there and back, and one that leads out of a third clip only.
MotionGraph threeClips() {
  return buildGraph(std::vector<std::uint32_t>{100, 100, 50},
                    std::vector<FrameTransition>{jump(60, 120), jump(170, 20), jump(210, 140)});
}

std::vector<std::size_t> framesOf(const MotionGraph& graph) {
  std::vector<std::size_t> frames;
  for (const FrameIndex node : graph.nodes) frames.push_back(node.value);
  return frames;
}

/// Whether every node can be reached from every other, by walking.
bool isStronglyConnected(const MotionGraph& graph) {
  for (std::size_t start = 0; start < graph.nodes.size(); ++start) {
    std::vector<bool> seen(graph.nodes.size(), false);
    std::vector<std::size_t> open = {start};
    seen[start] = true;
    std::size_t count = 0;
    while (!open.empty()) {
      const std::size_t node = open.back();
      open.pop_back();
      ++count;
      for (std::size_t e = graph.firstEdge[node]; e < graph.firstEdge[node + 1]; ++e) {
        const std::size_t next = graph.edges[e].to.value;
        if (!seen[next]) open.push_back(next);
        seen[next] = true;
      }
    }
    if (count != graph.nodes.size()) return false;
  }
  return true;
}

TEST(BuildGraph, makesNodesOfEndsAndAsManyClipPiecesAsNodesLessClips) {
  const MotionGraph graph = threeClips();
  EXPECT_EQ(framesOf(graph),
            (std::vector<std::size_t>{0, 20, 60, 99, 100, 120, 140, 170, 199, 200, 210, 249}));
  EXPECT_EQ(graph.clipPieceCount(), graph.nodes.size() - 3);
  EXPECT_EQ(graph.transitionCount(), 3U);
  ASSERT_EQ(graph.firstEdge.size(), graph.nodes.size() + 1);
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    for (std::size_t e = graph.firstEdge[n]; e < graph.firstEdge[n + 1]; ++e) {
      EXPECT_EQ(graph.edges[e].from.value, n);
      if (graph.edges[e].kind == EdgeKind::kClipPiece) {
        EXPECT_EQ(graph.edges[e].frames, graph.nodes[graph.edges[e].to.value].value - graph.nodes[n].value);
      } else {
        EXPECT_EQ(graph.edges[e].frames, 12U);
      }
    }
  }
}

TEST(BuildGraph, doesNotDependOnTheOrderOfTransitions) {
  const MotionGraph a = threeClips();
  const MotionGraph b =
      buildGraph(std::vector<std::uint32_t>{100, 100, 50},
                 std::vector<FrameTransition>{jump(210, 140), jump(170, 20), jump(60, 120)});
  ASSERT_EQ(a.edges.size(), b.edges.size());
  for (std::size_t e = 0; e < a.edges.size(); ++e) {
    EXPECT_EQ(a.edges[e].from, b.edges[e].from);
    EXPECT_EQ(a.edges[e].to, b.edges[e].to);
  }
}

TEST(BuildGraph, passesOverEmptyClipsAndGivesSingleFramesOneNode) {
  const MotionGraph graph = buildGraph(std::vector<std::uint32_t>{0, 5, 0, 1, 4}, {});
  EXPECT_EQ(framesOf(graph), (std::vector<std::size_t>{0, 4, 5, 6, 9}));
  EXPECT_EQ(graph.edges.size(), 2U);
}

TEST(LargestStronglyConnectedPart, keepsTheLoopAndDropsDeadEndsAndSources) {
  const MotionGraph part = largestStronglyConnectedPart(threeClips());
  EXPECT_EQ(framesOf(part), (std::vector<std::size_t>{20, 60, 120, 140, 170}));
  EXPECT_EQ(part.clipPieceCount(), 3U);
  EXPECT_EQ(part.transitionCount(), 2U);
  EXPECT_TRUE(isStronglyConnected(part));
}

TEST(LargestStronglyConnectedPart, isEmptyWithoutAnyLoop) {
  const MotionGraph part = largestStronglyConnectedPart(
      buildGraph(std::vector<std::uint32_t>{100, 100}, std::vector<FrameTransition>{jump(60, 120)}));
  EXPECT_TRUE(part.nodes.empty());
  EXPECT_TRUE(part.edges.empty());
  EXPECT_EQ(part.firstEdge, std::vector<std::uint32_t>{0});
}

TEST(LargestStronglyConnectedPart, takesTheEarlierOfTwoEqualParts) {
  const MotionGraph part = largestStronglyConnectedPart(buildGraph(
      std::vector<std::uint32_t>{100, 100}, std::vector<FrameTransition>{jump(150, 120), jump(50, 20)}));
  EXPECT_EQ(framesOf(part), (std::vector<std::size_t>{20, 50}));
}

TEST(LargestStronglyConnectedPart, isSoundAndMaximalOnRandomGraphs) {
  Random random(21);
  for (int i = 0; i < 50; ++i) {
    std::vector<FrameTransition> transitions;
    for (std::uint64_t k = 0; k < 12; ++k) transitions.push_back(jump(random.below(200), random.below(200)));
    const MotionGraph whole = buildGraph(std::vector<std::uint32_t>{70, 30, 100}, transitions);
    const MotionGraph part = largestStronglyConnectedPart(whole);
    EXPECT_TRUE(isStronglyConnected(part));
    EXPECT_LE(part.nodes.size(), whole.nodes.size());
  }
}

TEST(LargestStronglyConnectedPart, copesWithAHundredThousandNodesInARow) {
  std::vector<FrameTransition> transitions = {jump(99'999, 0)};
  for (std::size_t f = 1; f < 99'999; ++f) transitions.push_back(jump(f, f));
  const MotionGraph graph = buildGraph(std::vector<std::uint32_t>{100'000}, transitions);
  EXPECT_EQ(largestStronglyConnectedPart(graph).nodes.size(), 100'000U);
}

TEST(WithoutPassThroughNodes, mergesPiecesAcrossNodesThatDecideNothing) {
  const MotionGraph graph = withoutPassThroughNodes(largestStronglyConnectedPart(threeClips()));
  EXPECT_EQ(framesOf(graph), (std::vector<std::size_t>{20, 60, 120, 170}));
  EXPECT_EQ(graph.clipPieceCount(), 2U);
  EXPECT_EQ(graph.transitionCount(), 2U);
  EXPECT_EQ(graph.edges[0].frames, 40U);
  EXPECT_EQ(graph.edges[2].frames, 50U);
  EXPECT_TRUE(isStronglyConnected(graph));
}

TEST(WithoutPassThroughNodes, keepsNodesWhereAnyTransitionMeets) {
  const MotionGraph graph = largestStronglyConnectedPart(
      buildGraph(std::vector<std::uint32_t>{100},
                 std::vector<FrameTransition>{jump(80, 20), jump(60, 40), jump(30, 50)}));
  EXPECT_EQ(framesOf(withoutPassThroughNodes(graph)), framesOf(graph));
}

}  // namespace
}  // namespace stridegraph
