#include "graph/region_transitions.h"

#include <gtest/gtest.h>

namespace stridegraph {
namespace {

TEST(RegionTransitions, leadFromEachPieceToTheEndOfTheOther) {
  const std::vector<AlikeRegion> regions = {
      {FrameIndex(std::size_t{10}), FrameIndex(std::size_t{50}), 11, 13, 0.02F}};
  const std::vector<FrameTransition> transitions = transitionsOf(regions);
  ASSERT_EQ(transitions.size(), 2U);
  EXPECT_EQ(transitions[0].from.value, 10U);
  EXPECT_EQ(transitions[0].to.value, 63U);
  EXPECT_EQ(transitions[0].sourceSpan, 11U);
  EXPECT_EQ(transitions[0].targetSpan, 13U);
  EXPECT_EQ(transitions[1].from.value, 50U);
  EXPECT_EQ(transitions[1].to.value, 21U);
  EXPECT_EQ(transitions[1].sourceSpan, 13U);
  EXPECT_EQ(transitions[1].targetSpan, 11U);
  for (const FrameTransition& transition : transitions) {
    EXPECT_EQ(transition.frames, 12U);
    EXPECT_EQ(transition.distanceMetres, 0.02F);
  }
}

}  // namespace
}  // namespace stridegraph
