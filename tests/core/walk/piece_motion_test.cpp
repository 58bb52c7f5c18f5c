#include "walk/piece_motion.h"

#include <gtest/gtest.h>

#include "walk/test_library.h"

namespace stridegraph {
namespace {

using testing::kStepMetres;
using testing::threeArcs;

TEST(PieceTrack, ofAStraightClipPieceGoesForward) {
  const MotionLibrary library = threeArcs();
  const std::vector<FloorTransform> track =
      pieceTrack(library, pieceOf(library.graph, library.graph.edges[0]));
  ASSERT_EQ(track.size(), 13U);
  EXPECT_LT(track[0].translation.norm(), 1e-12);
  EXPECT_TRUE(track[12].translation.isApprox(Vec2(0, 12 * kStepMetres), 1e-9));
}

TEST(PieceTrack, startsAtTheIdentityAndMovesOneStepAFrameOnEveryEdge) {
  const MotionLibrary library = threeArcs();
  for (const MotionEdge& edge : library.graph.edges) {
    const std::vector<FloorTransform> track = pieceTrack(library, pieceOf(library.graph, edge));
    ASSERT_EQ(track.size(), edge.frames + 1);
    EXPECT_LT(track[0].translation.norm(), 1e-12);
    EXPECT_NEAR(track[0].heading.cos, 1.0, 1e-12);
    for (std::size_t p = 1; p < track.size(); ++p) {
      EXPECT_NEAR((track[p].translation - track[p - 1].translation).norm(), kStepMetres, 2e-3);
    }
  }
}

TEST(PieceTrack, ofATransitionTurnsFromTheOneRateToTheOther) {
  const MotionLibrary library = threeArcs();
  const MotionEdge& straightToLeft = library.graph.edges[2];
  const double turned =
      pieceTrack(library, pieceOf(library.graph, straightToLeft)).back().heading.angle().degrees();
  EXPECT_GT(turned, 15.0);
  EXPECT_LT(turned, 30.0);
}

/// The poses of a piece at positions 0..frames.
Clip posesOf(const MotionLibrary& library, const MotionPiece& piece) {
  Clip poses{.name = {},
             .framesPerSecond = library.frames.framesPerSecond,
             .jointCount = library.skeleton.size(),
             .rootPositions = std::vector<Vec3>(piece.frames + 1),
             .rotations = std::vector<Quat>((piece.frames + 1) * library.skeleton.size())};
  const PieceMotion motion(library, piece);
  for (std::size_t p = 0; p <= piece.frames; ++p)
    motion.pose(p, poses.rootPositions[p], poses.rotationsOf(p));
  return poses;
}

TEST(PieceMotion, placesItsPosesAsTheTrackDoes) {
  const MotionLibrary library = threeArcs();
  for (const MotionEdge& edge : library.graph.edges) {
    const MotionPiece piece = pieceOf(library.graph, edge);
    const std::vector<FloorTransform> track = pieceTrack(library, piece);
    const PieceMotion motion(library, piece);
    const FloorTransform trackFromPiece = motion.placement(0).inverse();
    const Clip poses = posesOf(library, piece);
    ASSERT_EQ(poses.frameCount(), track.size());
    for (std::size_t p = 0; p < track.size(); ++p) {
      const Vec2 root = onFloor(trackFromPiece.apply(poses.rootPositions[p]));
      EXPECT_LT((root - track[p].translation).norm(), 1e-9);
      EXPECT_LT(((trackFromPiece * motion.placement(p)).translation - track[p].translation).norm(), 1e-9);
    }
  }
}

TEST(PieceMotion, ofATransitionBeginsAndEndsWithTheCapturedPoses) {
  const MotionLibrary library = threeArcs();
  const MotionEdge& edge = library.graph.edges[2];
  const Clip poses = posesOf(library, pieceOf(library.graph, edge));
  const PoseView from = library.frames.pose(library.graph.nodes[edge.from.value].value);
  const PoseView to = library.frames.pose(library.graph.nodes[edge.to.value].value);
  EXPECT_LT(angleBetween(poses.pose(0).rotations[1], from.rotations[1]).radians(), 1e-6);
  EXPECT_LT(angleBetween(poses.pose(edge.frames).rotations[1], to.rotations[1]).radians(), 1e-6);
}

}  // namespace
}  // namespace stridegraph
