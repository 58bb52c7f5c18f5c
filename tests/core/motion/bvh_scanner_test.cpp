#include "motion/bvh_scanner.h"

#include <gtest/gtest.h>

#include "base/utf8.h"

namespace stridegraph {
namespace {

std::string foundIn(std::string_view text) {
  BvhScanner scanner(text, "");
  return scanner.expected("a word").value().message;
}

TEST(BvhScanner, quotesTheNextWordShortenedAtACharacter) {
  EXPECT_EQ(foundIn("  some word"), "found \"some\", expected a word");
  EXPECT_EQ(foundIn(" \n"), "found the end of the text, expected a word");
  EXPECT_EQ(foundIn(std::string(40, 'x')), "found \"" + std::string(40, 'x') + "\", expected a word");
  EXPECT_EQ(foundIn(std::string(39, 'x') + "\xC3\xA4tail"),
            "found \"" + std::string(39, 'x') + "...\", expected a word");
  EXPECT_EQ(foundIn("a\x01z"), "found \"a?z\", expected a word");
}

TEST(BvhScanner, quotesUtf8WhateverTheTextIs) {
  for (int byte = 1; byte < 256; ++byte) {
    EXPECT_TRUE(isUtf8(foundIn(std::string(1, static_cast<char>(byte)))));
    EXPECT_TRUE(isUtf8(foundIn(std::string(45, static_cast<char>(byte)))));
    EXPECT_TRUE(isUtf8(foundIn(std::string(39, 'x') + "\xC3" + static_cast<char>(byte))));
  }
}

TEST(BvhScanner, findsTheEndOfALine) {
  BvhScanner scanner("a \t\v\r\n b", "");
  EXPECT_FALSE(scanner.atLineEnd());
  EXPECT_TRUE(scanner.takeSymbol('a'));
  EXPECT_TRUE(scanner.atLineEnd());
  EXPECT_TRUE(scanner.atLineEnd()) << "it stays there";
  EXPECT_FALSE(scanner.atEnd());
  EXPECT_FALSE(scanner.atLineEnd());
  EXPECT_TRUE(scanner.takeSymbol('b'));
  EXPECT_TRUE(scanner.atLineEnd());
  EXPECT_TRUE(scanner.atEnd());
}

TEST(BvhScanner, takesWholeWordsAlone) {
  BvhScanner scanner("Joint\xC3\xA4 END_SITE End{", "");
  EXPECT_FALSE(scanner.takeWord("JOINT"));
  EXPECT_EQ(scanner.takeName(), "Joint\xC3\xA4 END_SITE End");
  EXPECT_TRUE(scanner.takeSymbol('{'));
}

}  // namespace
}  // namespace stridegraph
