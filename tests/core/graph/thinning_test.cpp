#include "graph/thinning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "graph/graph_building.h"
#include "math/random.h"

namespace stridegraph {
namespace {

constexpr std::uint32_t kBlend = 12;

FrameTransition jump(std::size_t from, std::size_t to) {
  return {FrameIndex(from), FrameIndex(to), kBlend, kBlend, kBlend, 0.01F};
}

std::vector<LibraryClip> clipsOf(std::size_t count, std::uint32_t frames) {
  std::vector<LibraryClip> clips;
  for (std::uint32_t c = 0; c < count; ++c) clips.push_back({"clip", c * frames, frames, false});
  return clips;
}

MotionGraph graphOf(const std::vector<LibraryClip>& clips, std::span<const FrameTransition> transitions) {
  std::vector<std::uint32_t> counts;
  for (const LibraryClip& clip : clips) counts.push_back(clip.frameCount);
  return largestStronglyConnectedPart(buildGraph(counts, transitions));
}

/// Whether the graph has a node among the frames first..last.
bool reachesInto(const MotionGraph& graph, std::size_t first, std::size_t last) {
  return std::any_of(graph.nodes.begin(), graph.nodes.end(),
                     [&](FrameIndex node) { return node.value >= first && node.value <= last; });
}

/// The first clip runs in a circle. The second is like it all along, the third only where it begins and ends.
std::vector<FrameTransition> oneTwiceAndAnother() {
  std::vector<FrameTransition> transitions = {jump(287, 12), jump(15, 632), jump(880, 30)};
  for (std::size_t f = 15; f < 285; f += 10) {
    transitions.push_back(jump(f, 300 + f + kBlend));
    transitions.push_back(jump(300 + f, f + kBlend));
  }
  return transitions;
}

/// Clips of 300 frames with so many transitions between frames drawn at random.
MotionGraph randomGraph(const std::vector<LibraryClip>& clips, std::size_t transitions, Random& random) {
  const std::size_t frames = clips.back().firstFrame + clips.back().frameCount;
  std::vector<FrameTransition> drawn;
  while (drawn.size() < transitions) {
    const std::size_t from = random.below(frames);
    const std::size_t to = random.below(frames);
    if (from % 300 + kBlend < 300 && to % 300 >= kBlend) drawn.push_back(jump(from, to));
  }
  return graphOf(clips, drawn);
}

TEST(ThinnedGraph, isTheGraphWhereItIsSmallEnough) {
  const std::vector<LibraryClip> clips = clipsOf(3, 300);
  const MotionGraph graph = graphOf(clips, oneTwiceAndAnother());
  const MotionGraph same = thinnedGraph(graph, clips, {.mostTransitions = graph.transitionCount()});
  EXPECT_EQ(same.nodes, graph.nodes);
  EXPECT_EQ(same.edges.size(), graph.edges.size());
}

TEST(ThinnedGraph, showsEveryMotionBeforeItShowsOneAgain) {
  const std::vector<LibraryClip> clips = clipsOf(3, 300);
  const MotionGraph graph = graphOf(clips, oneTwiceAndAnother());
  const MotionGraph thin = thinnedGraph(graph, clips, {.mostTransitions = 5, .stretchFrames = 300});
  EXPECT_EQ(thin.transitionCount(), 3U);
  EXPECT_TRUE(reachesInto(thin, 0, 299));
  EXPECT_FALSE(reachesInto(thin, 300, 599));
  EXPECT_TRUE(reachesInto(thin, 600, 899));
}

TEST(ThinnedGraph, choosesAmongStretchesOfALongClip) {
  // What comes last is like what came first.
  const std::vector<LibraryClip> clips = {{"long", 0, 300, false}};
  std::vector<FrameTransition> transitions = {jump(80, 20), jump(180, 20), jump(280, 120)};
  for (std::size_t f = 0; f < 90; f += 10) {
    transitions.push_back(jump(f, 200 + f + kBlend));
    transitions.push_back(jump(200 + f, f + kBlend));
  }
  const MotionGraph graph = graphOf(clips, transitions);
  const MotionGraph thin = thinnedGraph(graph, clips, {.mostTransitions = 5, .stretchFrames = 100});
  EXPECT_EQ(thin.transitionCount(), 2U);
  EXPECT_TRUE(reachesInto(thin, 100, 199));
  EXPECT_FALSE(reachesInto(thin, 200, 299));
}

TEST(ThinnedGraph, isStronglyConnectedAndHasNoMoreTransitionsThanAsked) {
  Random random(4);
  const std::vector<LibraryClip> clips = clipsOf(20, 300);
  for (int i = 0; i < 20; ++i) {
    const MotionGraph graph = randomGraph(clips, 3000, random);
    const std::size_t most = 200 + random.below(2000);
    const MotionGraph thin = thinnedGraph(graph, clips, {.mostTransitions = most});
    EXPECT_LE(thin.transitionCount(), most);
    EXPECT_GT(thin.transitionCount(), most / 4);
    EXPECT_EQ(largestStronglyConnectedPart(thin).nodes, thin.nodes);
    EXPECT_TRUE(std::includes(graph.nodes.begin(), graph.nodes.end(), thin.nodes.begin(), thin.nodes.end()));
  }
}

}  // namespace
}  // namespace stridegraph
