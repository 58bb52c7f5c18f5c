#include "program/shown_text.h"

#include <gtest/gtest.h>

#include "base/utf8.h"
#include "math/random.h"
#include "program/json_document.h"
#include "program/rounding.h"

namespace stridegraph::tools {
namespace {

TEST(ShownText, isAlwaysUtf8WithoutControlCharacters) {
  Random random(7);
  for (int i = 0; i < 2000; ++i) {
    std::string bytes(random.below(30), ' ');
    for (char& byte : bytes) byte = static_cast<char>(random.below(256));
    const std::string shown = shownText(bytes);
    EXPECT_TRUE(isUtf8(shown));
    for (const char letter : shown) EXPECT_FALSE(letter >= 0 && (letter < ' ' || letter == 0x7F)) << shown;
    EXPECT_TRUE(isUtf8(quotedText(bytes)));
    EXPECT_LE(quotedText(bytes).size(), 65U);
  }
}

TEST(ShownText, keepsWhatCanBeShown) {
  EXPECT_EQ(shownText("gang \xe8\xb7\xaf.bvh"), "gang \xe8\xb7\xaf.bvh");
  EXPECT_EQ(shownText("gr\xf6\xdf"
                      "e.bvh"),
            "gr\xc3\xb6\xc3\x9f"
            "e.bvh")
      << "Windows-1252";
  EXPECT_EQ(shownText("a\x1b[2Jb\n"), "a\xef\xbf\xbd[2Jb\xef\xbf\xbd");
  EXPECT_EQ(shownText("a\xc2\x9b"
                      "b"),
            "a\xef\xbf\xbd"
            "b")
      << "a control character of two bytes";
}

TEST(QuotedText, quotesWhatIsEmptyOrHasBlanksAndCutsWhatIsLong) {
  EXPECT_EQ(quotedText("walk"), "walk");
  EXPECT_EQ(quotedText(""), "\"\"");
  EXPECT_EQ(quotedText("a b"), "\"a b\"");
  EXPECT_EQ(quotedText(std::string(100, 'x')), std::string(60, 'x') + "...");
  EXPECT_EQ(quotedText(std::string(59, 'x') + "\xc3\xa4z"), std::string(59, 'x') + "...");
}

TEST(JsonDocument, holdsUtf8WhateverTheTexts) {
  const std::string text = documentText({{"name", "a\xff"}});
  EXPECT_TRUE(isUtf8(text));
  EXPECT_EQ(text, "{\n \"name\": \"a\xef\xbf\xbd\"\n}\n");
}

TEST(JsonDocument, tellsNotesInParts) {
  const Json notes = notesJson({{"odd", {"room.json", 3, 7}, WarningTopic::kScene}, {"plain"}});
  EXPECT_EQ(notes.dump(), R"([{"topic":"scene","message":"odd","file":"room.json","line":3,"column":7},)"
                          R"({"topic":"other","message":"plain"}])");
}

TEST(Rounding, keepsThreeDigits) {
  EXPECT_EQ(rounded(0.0), "0");
  EXPECT_EQ(rounded(-0.0), "0");
  EXPECT_EQ(rounded(0.051234), "0.0512");
  EXPECT_EQ(rounded(12.345), "12.3");
  EXPECT_EQ(rounded(999.6), "1000");
  EXPECT_EQ(rounded(-1234.5678), "-1235");
  EXPECT_EQ(rounded(30.0), "30");
}

TEST(Rounding, givesDurationsInTwoUnits) {
  EXPECT_EQ(roundedSeconds(0.44), "0.4 s");
  EXPECT_EQ(roundedSeconds(9.96), "10 s");
  EXPECT_EQ(roundedSeconds(59.6), "1 min 0 s");
  EXPECT_EQ(roundedSeconds(200.0), "3 min 20 s");
  EXPECT_EQ(roundedSeconds(7500.0), "2 h 5 min");
  EXPECT_EQ(roundedSeconds(1e300), "very long");
}

TEST(Rounding, givesBytesInPowersOf1024) {
  EXPECT_EQ(roundedBytes(512), "512 bytes");
  EXPECT_EQ(roundedBytes(std::uint64_t{16} << 20U), "16 MiB");
  EXPECT_EQ(roundedBytes((std::uint64_t{3} << 30U) / 2), "1.5 GiB");
  EXPECT_EQ(roundedBytes(std::uint64_t{1} << 63U), "8388608 TiB");
}

}  // namespace
}  // namespace stridegraph::tools
