#include "walk/edge_motion.h"

#include <gtest/gtest.h>

#include "walk/test_library.h"

namespace stridegraph {
namespace {

using testing::kStepMetres;
using testing::threeArcs;

TEST(EdgeTrack, ofAStraightClipPieceGoesForward) {
  const MotionLibrary library = threeArcs();
  const std::vector<FloorTransform> track = edgeTrack(library, library.graph.edges[0]);
  ASSERT_EQ(track.size(), 13U);
  EXPECT_LT(track[0].translation.norm(), 1e-12);
  EXPECT_TRUE(track[12].translation.isApprox(Vec2(0, 12 * kStepMetres), 1e-9));
}

TEST(EdgeTrack, startsAtTheIdentityAndMovesOneStepAFrameOnEveryEdge) {
  const MotionLibrary library = threeArcs();
  for (const MotionEdge& edge : library.graph.edges) {
    const std::vector<FloorTransform> track = edgeTrack(library, edge);
    ASSERT_EQ(track.size(), edge.frames + 1);
    EXPECT_LT(track[0].translation.norm(), 1e-12);
    EXPECT_NEAR(track[0].heading.cos, 1.0, 1e-12);
    for (std::size_t p = 1; p < track.size(); ++p) {
      EXPECT_NEAR((track[p].translation - track[p - 1].translation).norm(), kStepMetres, 2e-3);
    }
  }
}

TEST(EdgeTrack, ofATransitionTurnsFromTheOneRateToTheOther) {
  const MotionLibrary library = threeArcs();
  const MotionEdge& straightToLeft = library.graph.edges[2];
  const double turned = edgeTrack(library, straightToLeft).back().heading.angle().degrees();
  EXPECT_GT(turned, 15.0);
  EXPECT_LT(turned, 30.0);
}

TEST(EdgePoses, lieOnTheEdgesTrackOncePlaced) {
  const MotionLibrary library = threeArcs();
  const FloorTransform placement{{3, 4}, Heading::fromAngle(Angle::degrees(70))};
  for (const MotionEdge& edge : library.graph.edges) {
    const std::vector<FloorTransform> track = edgeTrack(library, edge);
    const Clip poses = edgePoses(library, edge);
    const FloorTransform roomFromEdge = placeEdge(library, edge, placement);
    ASSERT_EQ(poses.frameCount(), track.size());
    for (std::size_t p = 0; p < track.size(); ++p) {
      const Vec2 root = onFloor(roomFromEdge.apply(poses.rootPositions[p]));
      EXPECT_LT((root - placement * track[p].translation).norm(), 1e-9);
    }
  }
}

TEST(EdgePoses, ofATransitionBeginAndEndWithTheCapturedPoses) {
  const MotionLibrary library = threeArcs();
  const MotionEdge& edge = library.graph.edges[2];
  const Clip poses = edgePoses(library, edge);
  const PoseView from = library.frames.pose(library.graph.nodes[edge.from.value].value);
  const PoseView to = library.frames.pose(library.graph.nodes[edge.to.value].value);
  EXPECT_LT(angleBetween(poses.pose(0).rotations[1], from.rotations[1]).radians(), 1e-6);
  EXPECT_LT(angleBetween(poses.pose(edge.frames).rotations[1], to.rotations[1]).radians(), 1e-6);
}

}  // namespace
}  // namespace stridegraph
