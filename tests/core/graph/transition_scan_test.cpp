#include "graph/transition_scan.h"

#include <gtest/gtest.h>

#include "graph/pose_distance.h"
#include "motion/test_motions.h"

namespace stridegraph {
namespace {

using testing::walker;
using testing::walkOf;
using testing::wanderingClip;

struct Scanned {
  std::vector<FoundTransition> transitions;
  std::size_t framePairs = 0;
  std::size_t steps = 0;
};

Scanned scan(const std::vector<Clip>& clips, const ValleyParams& params = {}) {
  const FeatureBasis basis = featureBasis(walker(), clips);
  std::vector<ClipFeatures> features;
  for (const Clip& clip : clips) features.emplace_back(walker(), basis, clip);
  TransitionScan transitionScan(std::move(features), params);
  Scanned result;
  double progress = transitionScan.progress();
  while (transitionScan.step()) {
    ++result.steps;
    EXPECT_GE(transitionScan.progress(), progress);
    progress = transitionScan.progress();
  }
  EXPECT_EQ(transitionScan.progress(), 1.0);
  result.framePairs = transitionScan.framePairs();
  result.transitions = transitionScan.take();
  return result;
}

TEST(TransitionScan, joinsAWalkWithItselfAFullCycleApart) {
  // The cycle takes 30 frames and the walk repeats itself exactly.
  const std::vector<FoundTransition> found = scan({walkOf({.frames = 70})}).transitions;
  ASSERT_FALSE(found.empty());
  for (const FoundTransition& transition : found) {
    const auto forth =
        static_cast<std::ptrdiff_t>(transition.to.frame) - static_cast<std::ptrdiff_t>(transition.from.frame);
    // 12 blended steps, and 30 frames ahead or back.
    EXPECT_TRUE(forth == 12 + 30 || forth == 12 - 30) << forth;
    EXPECT_LT(transition.meanDistanceMetres, 1e-3);
    EXPECT_GE(transition.from.frame, kWindowReach);
    EXPECT_LT(transition.to.frame + kWindowReach, 70U);
  }
}

TEST(TransitionScan, usesARegionOfTwoClipsBothWays) {
  const std::vector<FoundTransition> found =
      scan({walkOf({.frames = 40}), walkOf({.frames = 45, .phaseCycles = 0.3})}).transitions;
  std::size_t there = 0;
  std::size_t back = 0;
  for (const FoundTransition& transition : found) {
    if (transition.from.clip == 0 && transition.to.clip == 1) ++there;
    if (transition.from.clip == 1 && transition.to.clip == 0) ++back;
  }
  EXPECT_GT(there, 0U);
  EXPECT_EQ(there, back);
}

TEST(TransitionScan, statesTheMeanDistanceAlongTheRegion) {
  const std::vector<Clip> clips = {walkOf({.frames = 40}),
                                   walkOf({.frames = 45, .speedMetresPerSecond = 1.3})};
  const std::vector<FoundTransition> found = scan(clips).transitions;
  ASSERT_FALSE(found.empty());
  for (const FoundTransition& transition : found) {
    double sum = 0.0;
    for (std::size_t k = 0; k < 13; ++k) {
      const double distance =
          poseDistanceMetres(walker(), clips[transition.from.clip], transition.from.frame + k,
                             clips[transition.to.clip], transition.to.frame - 12 + k);
      EXPECT_LE(distance, 0.0501);
      sum += distance;
    }
    EXPECT_NEAR(transition.meanDistanceMetres, sum / 13.0, 1e-5);
  }
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
