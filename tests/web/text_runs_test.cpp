#include "state/text_runs.h"

#include <gtest/gtest.h>

#include <random>

#include "base/utf8.h"

namespace stridegraph {
namespace {

/// Latin and Cyrillic, as a font may hold them, and line breaks.
bool inTestFont(char32_t codePoint) {
  return codePoint < 0x17F || (codePoint >= 0x400 && codePoint <= 0x45F);
}

std::vector<std::string> picturesOf(std::string_view text) {
  std::vector<std::string> pictures;
  for (const TextRun& run : splitRuns(text, inTestFont)) {
    if (!run.inFont) pictures.emplace_back(run.text);
  }
  return pictures;
}

using Texts = std::vector<std::string>;

TEST(TextRuns, areOneWhereTheFontHoldsAll) {
  const std::vector<TextRun> runs = splitRuns("Labyrinth Лабиринт é", inTestFont);
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_TRUE(runs[0].inFont);
  EXPECT_TRUE(splitRuns("", inTestFont).empty());
}

TEST(TextRuns, areSingleCharactersWhereLinesBreakAnywhere) {
  EXPECT_EQ(picturesOf("Raum 迷路 かな"), (Texts{"迷", "路", "か", "な"}));
  EXPECT_EQ(picturesOf("서울"), (Texts{"서", "울"}));
}

TEST(TextRuns, areWordsWhereLettersJoin) {
  EXPECT_EQ(picturesOf("कमरा एक"), (Texts{"कमरा", "एक"}));
}

TEST(TextRuns, keepWordsFromRightToLeftTogetherWithWhatIsBetween) {
  EXPECT_EQ(picturesOf("Raum: غرفة 2 كبيرة (A)"), (Texts{"غرفة 2 كبيرة"}));
  EXPECT_EQ(picturesOf("غرفة\nb\nكبيرة"), (Texts{"غرفة", "كبيرة"}));
}

TEST(TextRuns, giveACombiningMarkTheCharacterBeforeIt) {
  EXPECT_EQ(picturesOf("cafe\u0301 x"), (Texts{"e\u0301"}));
  EXPECT_EQ(picturesOf("か\u3099き"), (Texts{"か\u3099", "き"}));
}

TEST(TextRuns, keepAnEmojiOfSeveralCodePointsWhole) {
  EXPECT_EQ(picturesOf("a \U0001F469\u200D\U0001F680 b"), (Texts{"\U0001F469\u200D\U0001F680"}));
  EXPECT_EQ(picturesOf("1\uFE0F\u20E3"), (Texts{"1\uFE0F\u20E3"}));
}

TEST(TextRuns, areTheTextInTheirOrderWhateverItIs) {
  std::mt19937 random(5);
  const char32_t samples[] = {'a',    ' ',     0x301,  0x5D0, 0x660,   0x6587,
                              0xAC00, 0x1F600, 0x200D, 0x416, 0x10FFFF};
  for (int repeat = 0; repeat < 500; ++repeat) {
    std::string text;
    for (auto length = random() % 12; length > 0; --length) appendUtf8(samples[random() % 11], text);
    std::string joined;
    for (const TextRun& run : splitRuns(text, inTestFont)) {
      EXPECT_FALSE(run.text.empty());
      EXPECT_TRUE(isUtf8(run.text));
      joined += run.text;
    }
    EXPECT_EQ(joined, text);
  }
}

TEST(TextRuns, loseNoByteThatIsNoUtf8) {
  const std::string broken = "a\xff\xe4\xc3";
  std::string joined;
  for (const TextRun& run : splitRuns(broken, inTestFont)) joined += run.text;
  EXPECT_EQ(joined, broken);
}

TEST(ShortenedText, endsInAnEllipsisBetweenCodePoints) {
  EXPECT_EQ(shortened("迷路", 2), "迷路");
  EXPECT_EQ(shortened("迷路図", 2), "迷路…");
  EXPECT_EQ(shortened("", 0), "");
}

}  // namespace
}  // namespace stridegraph
