#include "figures/root_slip.h"

#include <gtest/gtest.h>

#include <numbers>

#include "motion/test_motions.h"
#include "motion/transition_blend.h"

namespace stridegraph::figures {
namespace {

using stridegraph::testing::walkOf;

std::vector<FloorTransform> placements(const Clip& clip) {
  std::vector<FloorTransform> track;
  for (std::size_t f = 0; f < clip.frameCount(); ++f) track.push_back(rootPlacement(clip.pose(f)));
  return track;
}

TEST(SidewaysSteps, areLeftOfTheWayFaced) {
  const std::vector<FloorTransform> track = {{{0.0, 0.0}, {}}, {{0.3, 1.0}, {}}};
  ASSERT_EQ(sidewaysSteps(track).size(), 1U);
  EXPECT_DOUBLE_EQ(sidewaysSteps(track)[0], 0.3);
  // A root that looks a quarter to the left of where the body faces: ahead is +x for it.
  const Heading quarter = Heading::fromAngle(Angle::degrees(90.0));
  const std::vector<FloorTransform> turned = {{{0.0, 0.0}, quarter}, {{0.3, 1.0}, quarter}};
  EXPECT_NEAR(sidewaysSteps(turned, quarter)[0], 0.3, 1e-12);
  EXPECT_NEAR(sidewaysSteps(turned)[0], -1.0, 1e-12);
}

TEST(SidewaysSlip, isNoneWhereTheBlendDoesWhatAClipDoes) {
  const std::vector<FloorTransform> straight = placements(walkOf({.frames = 30}));
  const std::vector<FloorTransform> turning =
      placements(walkOf({.frames = 30, .turnPerSecond = Angle::degrees(90)}));
  EXPECT_EQ(sidewaysSlip(straight, straight, turning), 0.0);
  EXPECT_EQ(sidewaysSlip(turning, straight, turning), 0.0);
}

// Fig. 5.7 in figures: a body that walks straight on is led into a turn.
TEST(SidewaysSlip, isCentimetresForThePlainBlendAndHardlyAMillimetreForTheDifferentialOne) {
  const Clip straight = walkOf({.frames = 41});
  for (const double degrees : {-90.0, -60.0, 60.0, 90.0, 120.0}) {
    const Clip turning = walkOf({.frames = 41, .turnPerSecond = Angle::degrees(degrees)});
    const auto slip = [&](RootBlend root) {
      return sidewaysSlip(blendTrack({{&straight, 0, 40}, {&turning, 0, 40}, 41, {BlendEase::kSmooth, root}}),
                          placements(straight), placements(turning));
    };
    EXPECT_GT(slip(RootBlend::kPlain), 0.05) << degrees;
    EXPECT_LT(slip(RootBlend::kDifferential), 0.001) << degrees;
  }
}

}  // namespace
}  // namespace stridegraph::figures
