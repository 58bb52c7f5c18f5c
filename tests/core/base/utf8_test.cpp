#include "base/utf8.h"

#include <gtest/gtest.h>

#include <random>

namespace stridegraph {
namespace {

TEST(Utf8, acceptsWellFormedTextsOfEveryLength) {
  EXPECT_TRUE(isUtf8(""));
  EXPECT_TRUE(isUtf8("plain"));
  EXPECT_TRUE(isUtf8("\xC3\xA9"));          // U+00E9
  EXPECT_TRUE(isUtf8("\xE4\xB8\xAD"));      // U+4E2D
  EXPECT_TRUE(isUtf8("\xF0\x9F\x9A\xB6"));  // U+1F6B6
}

TEST(Utf8, rejectsWhatIsNoSequence) {
  EXPECT_FALSE(isUtf8("\x80"));              // A continuation byte alone.
  EXPECT_FALSE(isUtf8("\xC3"));              // Cut off.
  EXPECT_FALSE(isUtf8("\xE4\xB8"));          // Cut off.
  EXPECT_FALSE(isUtf8("\xC0\x80"));          // Overlong.
  EXPECT_FALSE(isUtf8("\xE0\x80\x80"));      // Overlong.
  EXPECT_FALSE(isUtf8("\xF0\x80\x80\x80"));  // Overlong.
  EXPECT_FALSE(isUtf8("\xED\xA0\x80"));      // A surrogate.
  EXPECT_FALSE(isUtf8("\xF4\x90\x80\x80"));  // Above U+10FFFF.
  EXPECT_FALSE(isUtf8("\xF5\x80\x80\x80"));
  EXPECT_FALSE(isUtf8("a\xFF"));
}

TEST(Utf8, leavesUtf8Alone) {
  EXPECT_EQ(toUtf8("H\xC3\xBC\x66te"), "H\xC3\xBC\x66te");
}

TEST(Utf8, readsOtherBytesAsWindows1252) {
  EXPECT_EQ(toUtf8("H\xFC\x66te"), "H\xC3\xBC\x66te");
  EXPECT_EQ(toUtf8("\x80"), "\xE2\x82\xAC");  // The euro sign.
  EXPECT_EQ(toUtf8("\x9F"), "\xC5\xB8");      // U+0178
  EXPECT_EQ(toUtf8("\x81"), "\xC2\x81");      // Undefined in Windows-1252.
}

TEST(Utf8, makesUtf8OfAnyBytes) {
  std::mt19937 random(20);
  for (int i = 0; i < 500; ++i) {
    std::string bytes(random() % 24, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random() % 256);
    EXPECT_TRUE(isUtf8(toUtf8(bytes)));
  }
}

TEST(Utf8, roundTripsEveryCodePoint) {
  for (char32_t codePoint = 0; codePoint <= 0x10FFFF; codePoint += 7) {
    std::string text;
    appendUtf8(codePoint, text);
    EXPECT_TRUE(isUtf8(text));
  }
}

TEST(Utf8, replacesWhatIsNoCodePoint) {
  for (const char32_t codePoint : {char32_t(0xD800), char32_t(0xDFFF), char32_t(0x110000)}) {
    std::string text;
    appendUtf8(codePoint, text);
    EXPECT_EQ(text, "\xEF\xBF\xBD");
  }
}

}  // namespace
}  // namespace stridegraph
