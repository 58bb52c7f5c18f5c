#include "graph/window_sums.h"

#include <gtest/gtest.h>

namespace stridegraph {
namespace {

TEST(WindowSums, areThoseOfFiveNeighboursEach) {
  // Powers of ten show which numbers a sum holds.
  const auto sums = windowSums({1.0F, 10.0F, 100.0F, 1'000.0F, 10'000.0F, 100'000.0F, 200.0F, 20.0F});
  EXPECT_EQ(sums[0], 11'111.0F);
  EXPECT_EQ(sums[1], 111'110.0F);
  EXPECT_EQ(sums[2], 111'300.0F);
  EXPECT_EQ(sums[3], 111'220.0F);
}

}  // namespace
}  // namespace stridegraph
