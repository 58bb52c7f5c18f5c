#include "graph/similarity.h"

#include <gtest/gtest.h>

#include "graph/pose_distance.h"
#include "motion/test_motions.h"

namespace stridegraph {
namespace {

using testing::movedOnFloor;
using testing::walker;
using testing::wanderingClip;

ClipFeatures featuresOf(const std::vector<Clip>& clips, std::size_t k) {
  return {walker(), featureBasis(walker(), clips), clips[k]};
}

/// The whole matrix, cells left of the valid ones as 0.
std::vector<std::vector<std::uint32_t>> matrixOf(DistanceRows rows) {
  std::vector<std::vector<std::uint32_t>> matrix;
  while (const std::size_t count = rows.advance()) {
    for (std::size_t k = 0; k < count; ++k) {
      matrix.emplace_back(rows.row(k).begin(), rows.row(k).end());
      std::fill_n(matrix.back().begin(), rows.firstColumn(), 0U);
    }
  }
  return matrix;
}

double metres(std::uint32_t micrometres) {
  return static_cast<double>(micrometres) / kMicrometresPerMetre;
}

TEST(DistanceRows, agreeWithTheReferenceOnEveryPair) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    // Lengths that are no multiples of any block.
    const std::vector<Clip> clips = {wanderingClip(walker(), 41, seed),
                                     wanderingClip(walker(), 54, seed + 10)};
    const ClipFeatures a = featuresOf(clips, 0);
    const ClipFeatures b = featuresOf(clips, 1);
    const auto matrix = matrixOf(DistanceRows(a, b));
    ASSERT_EQ(matrix.size(), 37U);
    for (std::size_t r = 0; r < 37; ++r) {
      ASSERT_EQ(matrix[r].size(), 50U);
      for (std::size_t c = 0; c < 50; ++c)
        ASSERT_NEAR(metres(matrix[r][c]), poseDistanceMetres(walker(), clips[0], r + 2, clips[1], c + 2),
                    1e-5)
            << r << " " << c;
    }
  }
}

TEST(DistanceRows, staySharpWherePosesAreAllButEqual) {
  const Clip clip = wanderingClip(walker(), 40, 4);
  const std::vector<Clip> clips = {clip,
                                   movedOnFloor(clip, {{80, -60}, Heading::fromAngle(Angle::degrees(77))})};
  const ClipFeatures a = featuresOf(clips, 0);
  const ClipFeatures b = featuresOf(clips, 1);
  const auto matrix = matrixOf(DistanceRows(a, b));
  for (std::size_t r = 0; r < matrix.size(); ++r) EXPECT_LT(metres(matrix[r][r]), 2e-4);
}

TEST(DistanceRows, areZeroOnTheDiagonalOfAClipWithItself) {
  const std::vector<Clip> clips = {wanderingClip(walker(), 40, 5)};
  const ClipFeatures a = featuresOf(clips, 0);
  const auto matrix = matrixOf(DistanceRows(a, a));
  for (std::size_t r = 0; r < matrix.size(); ++r) EXPECT_EQ(matrix[r][r], 0U);
}

TEST(DistanceRows, ofOneClipAreTheWholeMatrixFromTheirReachOn) {
  const std::vector<Clip> clips = {wanderingClip(walker(), 61, 6)};
  const ClipFeatures a = featuresOf(clips, 0);
  const auto whole = matrixOf(DistanceRows(a, a));
  const auto half = matrixOf(DistanceRows(a, 5));
  ASSERT_EQ(half.size(), whole.size());
  for (std::size_t r = 0; r < whole.size(); ++r) {
    for (std::size_t c = r < 5 ? 0 : r - 5; c < whole.size(); ++c)
      EXPECT_EQ(half[r][c], whole[r][c]) << r << " " << c;
  }
  EXPECT_EQ(half[40][0], 0U);
}

TEST(DistanceRows, cutOffWhatIsFarApart) {
  const Clip clip = wanderingClip(walker(), 10, 7);
  Clip raised = clip;
  for (Vec3& root : raised.rootPositions) root.y() += 50.0;
  const std::vector<Clip> clips = {clip, raised};
  const ClipFeatures a = featuresOf(clips, 0);
  const ClipFeatures b = featuresOf(clips, 1);
  EXPECT_EQ(matrixOf(DistanceRows(a, b))[0][0], kFarMicrometres);
}

TEST(DistanceRows, areTheSameInTheMemoryOfOtherClips) {
  const std::vector<Clip> clips = {wanderingClip(walker(), 60, 10), wanderingClip(walker(), 33, 11),
                                   wanderingClip(walker(), 45, 12)};
  std::vector<ClipFeatures> features;
  for (std::size_t k = 0; k < clips.size(); ++k) features.push_back(featuresOf(clips, k));
  DistanceRows rows;
  EXPECT_EQ(rows.advance(), 0U);
  rows.restart(features[0], 3);
  EXPECT_EQ(matrixOf(rows), matrixOf(DistanceRows(features[0], 3)));
  for (const ClipFeatures& a : features) {
    for (const ClipFeatures& b : features) {
      rows.restart(a, b);
      std::vector<std::vector<std::uint32_t>> matrix;
      while (const std::size_t count = rows.advance()) {
        for (std::size_t k = 0; k < count; ++k) matrix.emplace_back(rows.row(k).begin(), rows.row(k).end());
      }
      EXPECT_EQ(matrix, matrixOf(DistanceRows(a, b)));
    }
  }
}

TEST(DistanceRows, areNoneForClipsShorterThanAWindow) {
  const std::vector<Clip> clips = {wanderingClip(walker(), 4, 8), wanderingClip(walker(), 30, 9)};
  const ClipFeatures brief = featuresOf(clips, 0);
  const ClipFeatures enough = featuresOf(clips, 1);
  EXPECT_EQ(DistanceRows(brief, enough).advance(), 0U);
  EXPECT_EQ(DistanceRows(enough, brief).advance(), 0U);
}

}  // namespace
}  // namespace stridegraph
