#include "motion/quoted_names.h"

#include <gtest/gtest.h>

#include <vector>

namespace stridegraph {
namespace {

TEST(QuotedNames, listsFourAndCountsTheRestOfMore) {
  const std::vector<std::string> names = {"a", "b", "c", "d", "e"};
  const std::span<const std::string> all(names);
  EXPECT_EQ(quotedNames(all.first(0)), "");
  EXPECT_EQ(quotedNames(all.first(1)), "\"a\"");
  EXPECT_EQ(quotedNames(all.first(2)), "\"a\" and \"b\"");
  EXPECT_EQ(quotedNames(all.first(4)), "\"a\", \"b\", \"c\" and \"d\"");
  EXPECT_EQ(quotedNames(all), "\"a\", \"b\", \"c\" and 2 more");
}

}  // namespace
}  // namespace stridegraph
