#include <gtest/gtest.h>

#include <set>

#include "math/random.h"
#include "walk/search_heap.h"
#include "walk/state_set.h"

namespace stridegraph {
namespace {

TEST(SearchHeap, popsByValueAndThenById) {
  SearchHeap heap;
  heap.push(2.0, 7);
  heap.push(1.0, 9);
  heap.push(1.0, 3);
  heap.push(3.0, 1);
  EXPECT_EQ(heap.pop(), 3U);
  EXPECT_EQ(heap.pop(), 9U);
  EXPECT_EQ(heap.pop(), 7U);
  EXPECT_EQ(heap.pop(), 1U);
  EXPECT_TRUE(heap.empty());
}

TEST(StateSet, hasKeyPartsForPlacesOutsideOfTheRoom) {
  EXPECT_EQ(keyPart(3.9), 3U);
  EXPECT_EQ(keyPart(-1.4), ~std::uint64_t{0});
  EXPECT_NE(keyPart(-2.0), keyPart(-1.0));
}

TEST(StateSet, agreesWithASetOfTheStandardLibraryWhileItGrows) {
  StateSet states;
  std::set<std::uint64_t> reference;
  Random random(5);
  for (int i = 0; i < 60'000; ++i) {
    const std::uint64_t key = random.below(50'000);
    EXPECT_EQ(states.contains(key), reference.contains(key));
    EXPECT_EQ(states.insert(key), reference.insert(key).second);
  }
}

}  // namespace
}  // namespace stridegraph
