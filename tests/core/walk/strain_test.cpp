#include "walk/strain.h"

#include <gtest/gtest.h>

#include <cmath>

#include "walk/piece_motion.h"
#include "walk/search_graph.h"
#include "walk/test_gait_library.h"
#include "walk/test_walker.h"
#include "walk/walk_cost.h"

namespace stridegraph {
namespace {

using namespace testing;

constexpr std::size_t kLeftKnee = 2;

/// A library of one clip in which the left knee turns a degree a frame, but by so many between frames 50
/// and 51; and of its mirror image, in which it does not.
MotionLibrary withAKneeThatTurns(double degrees, bool mirrored) {
  MotionLibrary library = standingLibrary();
  library.frames.rootPositions.clear();
  library.frames.rotations.clear();
  for (int f = 0; f < 200; ++f) {
    Pose pose = standing(15, {0, hipHeight(15), 0});
    const int inClip = f % 100;
    const double jump = inClip > 50 && (f >= 100) == mirrored ? degrees - 1.0 : 0.0;
    pose.rotations[kLeftKnee] = axisRotation(Axis::kX, Angle::degrees(inClip + jump));
    library.frames.append(pose.view());
  }
  library.contacts.assign(200, kAllDown);
  library.clips = {{"knee", 0, 100, false}, {"knee mirrored", 100, 100, true}};
  return library;
}

TEST(CapturedLimits, areThoseOfClipsThatAreNotMirrored) {
  const double calm = capturedLimits(withAKneeThatTurns(30, true)).speeds[kLeftKnee];
  EXPECT_NEAR(calm, Angle::degrees(30).radians(), 1e-6) << "a degree a frame";
  EXPECT_GT(capturedLimits(withAKneeThatTurns(30, false)).speeds[kLeftKnee], 2.0 * calm);
}

TEST(FrameStrains, tellByHowMuchAJointIsDrivenBeyondWhatWasCaptured) {
  const MotionLibrary library = withAKneeThatTurns(2.0, true);
  const std::vector<float> strains = frameStrains(library, capturedLimits(library));
  ASSERT_EQ(strains.size(), 200U);
  for (std::size_t f = 0; f < 200; ++f) {
    EXPECT_EQ(strains[f] > 0.0F, f == 151) << f;
    EXPECT_EQ(strains[f] * 64.0F, std::round(strains[f] * 64.0F));
  }
  EXPECT_NEAR(strains[151], 2.0 - kDrivenRatio, 1.0 / 64.0);
}

TEST(SearchGraph, waysHaveTheStrainOfTheFramesThatTheyShow) {
  const MotionLibrary& library = gaitPlanner().library();
  MotionLimits limits = capturedLimits(library);
  for (double& speed : limits.speeds) speed *= 0.5;
  const std::vector<float> strains = frameStrains(library, limits);
  const SearchGraph graph(library, limits);
  std::size_t strained = 0;
  for (const SearchEdge& way : graph.edges()) {
    double sum = 0.0;
    for (const WalkStep& step : graph.stepsOf(way)) {
      for (std::uint32_t p = step.begin + 1; p <= step.end; ++p)
        sum += static_cast<double>(strains[capturedFrameAt(step.piece, p)]);
    }
    ASSERT_EQ(way.strain, sum);
    if (sum > 0.0) ++strained;
  }
  EXPECT_GT(strained, 100U);
  EXPECT_LT(strained, graph.edges().size());
}

TEST(WalkCost, chargesStrain) {
  SearchEdge way;
  way.lengthMetres = 1.0;
  way.sampleCount = 30;
  const WalkCost cost;
  const double calm = cost.ofGoing(way, 30.0);
  way.strain = 0.5;
  EXPECT_NEAR(cost.ofGoing(way, 30.0) - calm, 0.5 * cost.perStrain, 1e-12);
}

}  // namespace
}  // namespace stridegraph
