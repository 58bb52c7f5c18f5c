#include "text_checks.h"

#include <gtest/gtest.h>

#include "target.h"

namespace stridegraph::fuzz {
namespace {

TEST(TextChecks, takeSentencesWithRealNumbers) {
  EXPECT_NO_THROW(requireSentence("it came to (0.0, 0.0), 1.5 m before it; a banana is no infinity"));
}

TEST(TextChecks, refuseNumbersThatAreNone) {
  EXPECT_THROW(requireSentence("it came to (0.0, 0.0), inf m before it"), BrokenPromise);
  EXPECT_THROW(requireSentence("it came to (-nan, 0.0)"), BrokenPromise);
}

TEST(TextChecks, refuseEmptySentencesAndOtherBytesThanUtf8) {
  EXPECT_THROW(requireSentence(""), BrokenPromise);
  EXPECT_THROW(requireSentence("gr\xfc\xdf"), BrokenPromise);
}

TEST(TextChecks, refusePlacesBehindTheEndOfAText) {
  const std::size_t lines = mostLines("a\nb\n");
  EXPECT_EQ(lines, 3U);
  EXPECT_NO_THROW(requireSound({ErrorCode::kBvhSyntax, "found nothing", {"a.bvh", 3, 1}}, lines));
  EXPECT_THROW(requireSound({ErrorCode::kBvhSyntax, "found nothing", {"a.bvh", 4, 1}}, lines), BrokenPromise);
}

}  // namespace
}  // namespace stridegraph::fuzz
