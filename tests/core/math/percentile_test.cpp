#include "math/percentile.h"

#include <gtest/gtest.h>

namespace stridegraph {
namespace {

TEST(Percentile, liesBetweenTheTwoNearestRanks) {
  EXPECT_DOUBLE_EQ(percentile({30.0, 10.0, 20.0}, 0.5), 20.0);
  EXPECT_DOUBLE_EQ(percentile({30.0, 10.0, 20.0}, 0.25), 15.0);
  EXPECT_DOUBLE_EQ(percentile({40.0, 10.0, 30.0, 20.0}, 0.9), 37.0);
}

TEST(Percentile, ofShare0And1IsTheLeastAndTheLargest) {
  EXPECT_DOUBLE_EQ(percentile({3.0, 1.0, 2.0}, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(percentile({3.0, 1.0, 2.0}, 1.0), 3.0);
}

TEST(Percentile, ofNothingIs0) {
  EXPECT_EQ(percentile({}, 0.5), 0.0);
}

}  // namespace
}  // namespace stridegraph
