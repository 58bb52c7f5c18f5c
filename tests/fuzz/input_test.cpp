#include "input.h"

#include <gtest/gtest.h>

#include <vector>

namespace stridegraph::fuzz {
namespace {

TEST(FuzzInput, readsFromTheFrontAndThenZeros) {
  const std::vector<std::uint8_t> bytes = {7, 0x34, 0x12};
  Input input(bytes);
  EXPECT_EQ(input.below(5), 2U);
  EXPECT_EQ(input.word(), 0x1234U);
  EXPECT_EQ(input.bytesLeft(), 0U);
  EXPECT_EQ(input.byte(), 0U);
  EXPECT_EQ(input.number(-3.0, 5.0), -3.0);
}

TEST(FuzzInput, coversARangeWithBothEnds) {
  const std::vector<std::uint8_t> bytes = {0, 0, 0xff, 0xff, 0xef, 0xff};
  Input input(bytes);
  EXPECT_EQ(input.number(-3.0, 5.0), -3.0);
  EXPECT_EQ(input.number(-3.0, 5.0), 5.0);
  EXPECT_EQ(input.oddNumber(-3.0, 5.0), 5.0);
}

TEST(FuzzInput, hasNumbersThatBreakArithmetic) {
  const std::vector<std::uint8_t> bytes = {0xff, 0xff, 0xfd, 0xff};
  Input input(bytes);
  EXPECT_TRUE(std::isnan(input.oddNumber(0.0, 1.0)));
  EXPECT_TRUE(std::isinf(input.oddNumber(0.0, 1.0)));
}

}  // namespace
}  // namespace stridegraph::fuzz
