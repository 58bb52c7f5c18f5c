#include "walk/synthesis.h"

#include <gtest/gtest.h>

#include "walk/search_graph.h"
#include "walk/test_library.h"

namespace stridegraph {
namespace {

using testing::kStepMetres;
using testing::threeArcs;

MotionPiece pieceOfEdge(std::size_t edge) {
  const MotionGraph graph = threeArcs().graph;
  return pieceOf(graph, graph.edges[edge]);
}

/// Straight piece, over to the left turn, its piece.
MotionPath turnLeft() {
  return {{{2, 3}, Heading::fromAngle(Angle::degrees(90))},
          {{pieceOfEdge(0), 4, 12}, {pieceOfEdge(2), 0, 12}, {pieceOfEdge(4), 0, 6}}};
}

TEST(Synthesise, beginsAtTheStartFacingAsAsked) {
  const SynthesisedWalk walk = synthesise(threeArcs(), turnLeft());
  EXPECT_TRUE(walk.clip.rootPositions[0].isApprox(Vec3(2, 1, 3), 1e-9));
  EXPECT_NEAR(separateHeading(walk.clip.pose(0).rotations[0]).heading.angle().degrees(), 90.0, 1e-6);
}

TEST(Synthesise, showsEveryFrameOnce) {
  const SynthesisedWalk walk = synthesise(threeArcs(), turnLeft());
  EXPECT_EQ(walk.clip.frameCount(), 1U + 8U + 12U + 6U);
  for (std::size_t f = 1; f < walk.clip.frameCount(); ++f) {
    EXPECT_NEAR((walk.clip.rootPositions[f] - walk.clip.rootPositions[f - 1]).norm(), kStepMetres, 2e-3) << f;
  }
}

/// A straight piece of 12 frames, bent by 20 degrees a metre to the right.
MotionPath straightBent() {
  return {{{2, 3}, Heading::fromAngle(Angle::degrees(90))}, {{pieceOfEdge(0), 0, 12, Angle::degrees(20)}}};
}

TEST(Synthesise, laysBentStepsOutOnAnArc) {
  const SynthesisedWalk walk = synthesise(threeArcs(), straightBent());
  // A chord polygon: every step as long as captured, and turned by 20 degrees times its length.
  FloorTransform at = {{2, 3}, Heading::fromAngle(Angle::degrees(90))};
  const Heading turn = Heading::fromAngle(Angle::degrees(20 * kStepMetres));
  for (std::size_t f = 1; f <= 12; ++f) {
    at = at * FloorTransform{turn.rotate({0, kStepMetres}), turn};
    EXPECT_LT((walk.placements[f].translation - at.translation).norm(), 1e-6) << f;
    EXPECT_LT((Vec2(walk.clip.rootPositions[f].x(), walk.clip.rootPositions[f].z()) - at.translation).norm(),
              1e-6)
        << f;
    EXPECT_NEAR(separateHeading(walk.clip.pose(f).rotations[0]).heading.angle().degrees(),
                at.heading.angle().degrees(), 1e-5)
        << f;
  }
}

TEST(Synthesise, tellsWhatBendingAccelerates) {
  const MotionLibrary library = threeArcs();
  const SynthesisedWalk walk = synthesise(library, straightBent());
  const double speed = kStepMetres * library.frames.framesPerSecond;
  EXPECT_EQ(walk.accelerations.size(), walk.clip.frameCount());
  EXPECT_EQ(walk.accelerations[0], Vec2(0, 0));
  for (std::size_t f = 1; f <= 12; ++f) {
    const Vec2 moved = walk.placements[f].translation - walk.placements[f - 1].translation;
    const Vec2 middle = {moved.y(), -moved.x()};  // A growing heading turns from +z towards +x.
    const double expected = Angle::degrees(20).radians() * speed * speed;
    EXPECT_NEAR((walk.accelerations[f] - expected * middle.normalized()).norm(), 0.0, 1e-6) << f;
  }
  for (const Vec2& added : synthesise(library, turnLeft()).accelerations) EXPECT_EQ(added, Vec2(0, 0));
}

TEST(Synthesise, bendsTheWayThatTheSearchHasBent) {
  const MotionLibrary library = threeArcs();
  const SearchGraph graph(library);
  for (const SearchEdge& way : graph.edgesFrom(0)) {
    const auto steps = graph.stepsOf(way);
    const std::vector<FloorTransform> placements =
        placementsAlong(library, {{}, {steps.begin(), steps.end()}});
    const auto samples = graph.samplesOf(way);
    ASSERT_EQ(placements.size(), samples.size() + 1);
    for (std::size_t s = 0; s < samples.size(); ++s)
      EXPECT_LT((placements[s + 1].translation - samples[s].cast<double>()).norm(), 1e-5) << s;
    EXPECT_LT((placements.back().translation - way.end.translation).norm(), 1e-9);
  }
}

TEST(Synthesise, tellsCapturedFromBlendedFrames) {
  const SynthesisedWalk walk = synthesise(threeArcs(), turnLeft());
  ASSERT_EQ(walk.frameKinds.size(), walk.clip.frameCount());
  EXPECT_EQ(walk.frameKinds[8], EdgeKind::kClipPiece);
  EXPECT_EQ(walk.frameKinds[9], EdgeKind::kTransition);
  EXPECT_EQ(walk.frameKinds[19], EdgeKind::kTransition);
  EXPECT_EQ(walk.frameKinds[20], EdgeKind::kClipPiece);
}

TEST(Synthesise, leavesCapturedFramesAsTheyAre) {
  const MotionLibrary library = threeArcs();
  const SynthesisedWalk walk = synthesise(library, turnLeft());
  for (std::size_t f = 0; f <= 8; ++f) {
    EXPECT_LT(
        angleBetween(walk.clip.pose(f).rotations[1], library.frames.pose(18 + f).rotations[1]).radians(),
        1e-9);
    EXPECT_EQ(walk.contacts[f], library.contacts[18 + f]);
  }
}

TEST(Synthesise, ofAStepWithoutFramesIsTheFirstPose) {
  const SynthesisedWalk walk = synthesise(threeArcs(), {{}, {{pieceOfEdge(0), 3, 3}}});
  EXPECT_EQ(walk.clip.frameCount(), 1U);
}

}  // namespace
}  // namespace stridegraph
