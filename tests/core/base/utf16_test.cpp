#include "base/utf16.h"

#include <gtest/gtest.h>

namespace stridegraph {
namespace {

using namespace std::string_view_literals;

constexpr auto kLittle = ByteOrder::kLittleEndian;
constexpr auto kBig = ByteOrder::kBigEndian;

TEST(Utf16, becomesUtf8InBothByteOrders) {
  // a, U+00FC, U+4E2D, U+1F6B6
  EXPECT_EQ(utf8FromUtf16("a\0\xFC\0\x2D\x4E\x3D\xD8\xB6\xDE"sv, kLittle).utf8,
            "a\xC3\xBC\xE4\xB8\xAD\xF0\x9F\x9A\xB6");
  EXPECT_EQ(utf8FromUtf16("\0a\0\xFC\x4E\x2D\xD8\x3D\xDE\xB6"sv, kBig).utf8,
            "a\xC3\xBC\xE4\xB8\xAD\xF0\x9F\x9A\xB6");
  EXPECT_EQ(utf8FromUtf16("", kLittle).utf8, "");
}

TEST(Utf16, leavesOutTheByteOrderMarkAtTheBeginningAlone) {
  EXPECT_EQ(utf8FromUtf16("\xFF\xFE\x61\0\xFF\xFE"sv, kLittle).utf8, "a\xEF\xBB\xBF");
  EXPECT_EQ(utf8FromUtf16("\xFE\xFF\0a"sv, kBig).utf8, "a");
}

TEST(Utf16, replacesAndCountsLoneSurrogates) {
  const Utf16Text high = utf8FromUtf16("\x3D\xD8\x61\0"sv, kLittle);
  EXPECT_EQ(high.utf8, "\xEF\xBF\xBD\x61");
  EXPECT_EQ(high.loneSurrogates, 1U);
  const Utf16Text all = utf8FromUtf16("\xB6\xDE\x3D\xD8"sv, kLittle);
  EXPECT_EQ(all.utf8, "\xEF\xBF\xBD\xEF\xBF\xBD");
  EXPECT_EQ(all.loneSurrogates, 2U);
}

TEST(Utf16, leavesOutHalfACharacterAtTheEndAndSaysSo) {
  const Utf16Text odd = utf8FromUtf16("a\0b"sv, kLittle);
  EXPECT_EQ(odd.utf8, "a");
  EXPECT_TRUE(odd.hasHalfUnit);
  EXPECT_FALSE(utf8FromUtf16("a\0"sv, kLittle).hasHalfUnit);
}

}  // namespace
}  // namespace stridegraph
