#include "math/random.h"

#include <gtest/gtest.h>

namespace stridegraph {
namespace {

TEST(Random, givesThePublishedBitsOfSplitMix64) {
  Random random(1234567);
  EXPECT_EQ(random.bits(), 6457827717110365317ULL);
  EXPECT_EQ(random.bits(), 3203168211198807973ULL);
}

TEST(Random, uniformStaysInItsRangeAndFillsIt) {
  Random random(7);
  double sum = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const double value = random.uniform(2.0, 4.0);
    ASSERT_GE(value, 2.0);
    ASSERT_LT(value, 4.0);
    sum += value;
  }
  EXPECT_NEAR(sum / 10000.0, 3.0, 0.03);
}

TEST(Random, belowReachesEveryNumberAndNoOther) {
  Random random(3);
  std::uint64_t seen = 0;
  for (int i = 0; i < 200; ++i) {
    const std::uint64_t value = random.below(5);
    ASSERT_LT(value, 5U);
    seen |= 1ULL << value;
  }
  EXPECT_EQ(seen, 31U);
}

}  // namespace
}  // namespace stridegraph
