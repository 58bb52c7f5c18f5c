#include "graph/transition_scan.h"

#include <gtest/gtest.h>

#include "graph/pose_distance.h"
#include "graph/region_transitions.h"
#include "motion/test_motions.h"

namespace stridegraph {
namespace {

using testing::walker;
using testing::walkOf;
using testing::wanderingClip;

/// Frames of the first clip of a scan, then those of the second.
struct Scanned {
  std::vector<FrameTransition> transitions;
  std::vector<AlikeRegion> regions;
  std::size_t framePairs = 0;
  std::size_t steps = 0;
};

Scanned scan(const std::vector<Clip>& clips, const ValleyParams& params = {}, KnownRegions known = {}) {
  const FeatureBasis basis = featureBasis(walker(), clips);
  std::vector<ClipFeatures> features;
  for (const Clip& clip : clips) features.emplace_back(walker(), basis, clip);
  TransitionScan transitionScan(std::move(features), params, std::move(known));
  Scanned result;
  double progress = transitionScan.progress();
  while (transitionScan.step()) {
    ++result.steps;
    EXPECT_GE(transitionScan.progress(), progress);
    progress = transitionScan.progress();
  }
  EXPECT_EQ(transitionScan.progress(), 1.0);
  result.framePairs = transitionScan.framePairs();
  result.regions = transitionScan.take();
  result.transitions = transitionsOf(result.regions);
  return result;
}

TEST(TransitionScan, joinsAWalkWithItselfAFullCycleApart) {
  // The cycle takes 30 frames and the walk repeats itself exactly.
  const std::vector<FrameTransition> found = scan({walkOf({.frames = 70})}).transitions;
  ASSERT_FALSE(found.empty());
  for (const FrameTransition& transition : found) {
    const auto forth =
        static_cast<std::ptrdiff_t>(transition.to.value) - static_cast<std::ptrdiff_t>(transition.from.value);
    // 12 blended steps, and 30 frames ahead or back.
    EXPECT_TRUE(forth == 12 + 30 || forth == 12 - 30) << forth;
    EXPECT_LT(transition.distanceMetres, 1e-3F);
    EXPECT_GE(transition.from.value, kWindowReach);
    EXPECT_LT(transition.to.value + kWindowReach, 70U);
  }
}

TEST(TransitionScan, usesARegionOfTwoClipsBothWays) {
  const std::vector<FrameTransition> found =
      scan({walkOf({.frames = 40}), walkOf({.frames = 45, .phaseCycles = 0.3})}).transitions;
  std::size_t there = 0;
  std::size_t back = 0;
  for (const FrameTransition& transition : found) {
    if (transition.from.value < 40 && transition.to.value >= 40) ++there;
    if (transition.from.value >= 40 && transition.to.value < 40) ++back;
  }
  EXPECT_GT(there, 0U);
  EXPECT_EQ(there, back);
}

TEST(TransitionScan, statesTheMeanDistanceAlongTheRegion) {
  const std::vector<Clip> clips = {walkOf({.frames = 40}),
                                   walkOf({.frames = 45, .speedMetresPerSecond = 1.3})};
  const std::vector<AlikeRegion> found = scan(clips, {.largestSpanRatio = 1.0}).regions;
  ASSERT_FALSE(found.empty());
  for (const AlikeRegion& region : found) {
    EXPECT_EQ(region.rowSpan, 12);
    EXPECT_EQ(region.columnSpan, 12);
    const auto placeOf = [&](FrameIndex frame) {
      return frame.value < 40 ? std::pair(0U, frame.value) : std::pair(1U, frame.value - 40);
    };
    const auto [rowClip, row] = placeOf(region.row);
    const auto [columnClip, column] = placeOf(region.column);
    double sum = 0.0;
    for (std::size_t k = 0; k < 13; ++k) {
      const double distance =
          poseDistanceMetres(walker(), clips[rowClip], row + k, clips[columnClip], column + k);
      EXPECT_LE(distance, 0.0501);
      sum += distance;
    }
    EXPECT_NEAR(static_cast<double>(region.distanceMetres), sum / 13.0, 1e-5);
  }
}

/// The walk, and the same walk a quarter slower.
std::vector<Clip> briskAndSlow() {
  return {walkOf({.frames = 45}),
          walkOf({.frames = 45, .speedMetresPerSecond = 0.96, .cyclesPerSecond = 0.8, .phaseCycles = 0.1})};
}

std::vector<AlikeRegion> regionsBetween(const Scanned& scanned, std::uint32_t secondClip) {
  std::vector<AlikeRegion> between = scanned.regions;
  std::erase_if(between, [&](const AlikeRegion& region) {
    return region.row.value >= secondClip || region.column.value < secondClip;
  });
  return between;
}

TEST(TransitionScan, joinsASlowAndABriskWalkOnlyByWarpingTime) {
  const ValleyParams params{.thresholdMetres = 0.025};
  ValleyParams equalOnly = params;
  equalOnly.largestSpanRatio = 1.0;
  EXPECT_TRUE(regionsBetween(scan(briskAndSlow(), equalOnly), 45).empty());
  const std::vector<AlikeRegion> found = regionsBetween(scan(briskAndSlow(), params), 45);
  ASSERT_FALSE(found.empty());
  for (const AlikeRegion& region : found) {
    EXPECT_LT(region.rowSpan, region.columnSpan);
    EXPECT_EQ(region.rowSpan + region.columnSpan, 24);
  }
}

TEST(TransitionScan, doesNotCompareKnownPairsAgain) {
  const std::vector<Clip> clips = {walkOf({.frames = 60}), walkOf({.frames = 50, .phaseCycles = 0.3}),
                                   walkOf({.frames = 70, .phaseCycles = 0.7})};
  const Scanned whole = scan(clips);
  KnownRegions known{{true, false, true}, {}};
  for (const AlikeRegion& region : whole.regions) {
    const auto isKnown = [](FrameIndex frame) { return frame.value < 60 || frame.value >= 110; };
    if (isKnown(region.row) && isKnown(region.column)) known.regions.push_back(region);
  }
  ASSERT_FALSE(known.regions.empty());
  const Scanned part = scan(clips, {}, known);
  EXPECT_EQ(part.regions, whole.regions);
  EXPECT_LT(part.framePairs, whole.framePairs - 56 * 66);
  const Scanned nothing = scan(clips, {}, {{true, true, true}, whole.regions});
  EXPECT_EQ(nothing.regions, whole.regions);
  EXPECT_EQ(nothing.framePairs, 0U);
}

TEST(TransitionScan, comparesEachPairOnceAndInSmallSteps) {
  const std::vector<Clip> clips = {wanderingClip(walker(), 300, 1), wanderingClip(walker(), 500, 2)};
  const Scanned scanned = scan(clips);
  EXPECT_GE(scanned.framePairs, 296U * 496 + 296 * 297 / 2 + 496 * 497 / 2);
  EXPECT_LT(scanned.framePairs, 296U * 496 + 296 * 310 / 2 + 496 * 510 / 2);
  EXPECT_GT(scanned.steps, 5U);
}

TEST(TransitionScan, findsNothingInClipsTooShortForARegion) {
  EXPECT_TRUE(
      scan({walkOf({.frames = 16}), walkOf({.frames = 3}), walkOf({.frames = 0})}).transitions.empty());
  EXPECT_FALSE(scan({walkOf({.frames = 17}), walkOf({.frames = 17})}).transitions.empty());
}

}  // namespace
}  // namespace stridegraph
