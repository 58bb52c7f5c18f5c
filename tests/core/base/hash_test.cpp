#include "base/hash.h"

#include <gtest/gtest.h>

namespace stridegraph {
namespace {

TEST(StableHash, givesThePublishedValuesOfFnv1a) {
  EXPECT_EQ(stableHash(std::string_view("")), 0xcbf29ce484222325ULL);
  EXPECT_EQ(stableHash(std::string_view("a")), 0xaf63dc4c8601ec8cULL);
  EXPECT_EQ(stableHash(std::string_view("foobar")), 0x85944171f73967e8ULL);
}

TEST(StableHash, goesOnFromAnEarlierHash) {
  EXPECT_EQ(stableHash(std::string_view("bar"), stableHash(std::string_view("foo"))),
            stableHash(std::string_view("foobar")));
}

TEST(HexDigits, areSixteenAndLowerCase) {
  EXPECT_EQ(hexDigits(0xABCULL), "0000000000000abc");
}

}  // namespace
}  // namespace stridegraph
