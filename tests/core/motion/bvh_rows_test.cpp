#include "motion/bvh_rows.h"

#include <gtest/gtest.h>

#include <numeric>

namespace stridegraph {
namespace {

/// Rows of three numbers that count from 0, in lines of so many.
std::string inLines(std::initializer_list<std::size_t> numbersOfLines) {
  std::string text;
  int next = 0;
  for (const std::size_t numbers : numbersOfLines) {
    for (std::size_t i = 0; i < numbers; ++i) text += (i > 0 ? " " : "") + std::to_string(next++);
    text += '\n';
  }
  return text;
}

/// "rows: warning; ..." of rows of three numbers, or why they are refused.
std::string outcome(std::string_view text, std::size_t declared, std::size_t columns = 3) {
  BvhScanner scanner(text, "");
  const Result<BvhRows> rows = parseBvhRows(scanner, {.columns = columns, .joints = 1, .declared = declared});
  if (!rows) return describe(rows.error());
  EXPECT_EQ(rows->values.size() % columns, 0U);
  std::string outcome = std::to_string(rows->values.size() / columns) + " rows";
  for (const Warning& warning : rows->warnings) {
    EXPECT_EQ(warning.topic, WarningTopic::kRows);
    outcome += "; " + describe(warning);
  }
  return outcome;
}

constexpr std::string_view kExpectedThree = ", expected 3, one for each channel in HIERARCHY";

std::string rowRefusal(std::string_view place, std::size_t found,
                       std::string_view expected = kExpectedThree) {
  return std::string(place) + ": found " + std::to_string(found) + " numbers in a row" +
         std::string(expected);
}

TEST(BvhRows, takesARowOfALine) {
  BvhScanner scanner("0 1 2\n3 4 5\n", "");
  const Result<BvhRows> rows = parseBvhRows(scanner, {.columns = 3, .joints = 1, .declared = 2});
  ASSERT_TRUE(rows);
  EXPECT_EQ(rows->values, (std::vector<double>{0, 1, 2, 3, 4, 5}));
  EXPECT_TRUE(rows->warnings.empty());
}

TEST(BvhRows, takesBlankLinesAnyLineEndsAndBlanksAround) {
  for (const std::string_view text : {"0 1 2\n3 4 5", "\n\n 0 1 2 \n\n\t3 4 5\t\n \n", "0 1 2\r\n3 4 5\r\n",
                                      "0 1 2\r3 4 5\r", "0\t1\v2\n3\f4 5", "0-1-2\n-3-4+5\n"}) {
    EXPECT_EQ(outcome(text, 2), "2 rows") << text;
  }
}

TEST(BvhRows, takesRowsThatAreWrappedOverLines) {
  EXPECT_EQ(outcome(inLines({2, 1, 2, 1, 2, 1}), 3), "3 rows");
  EXPECT_EQ(outcome(inLines({1, 1, 1, 1, 1, 1}), 2), "2 rows");
  EXPECT_EQ(outcome(inLines({3, 2, 1, 3, 1, 1, 1}), 4), "4 rows");
}

TEST(BvhRows, takesLinesOfSeveralRows) {
  EXPECT_EQ(outcome(inLines({6, 6, 3}), 5), "5 rows");
  EXPECT_EQ(outcome(inLines({12}), 4), "4 rows");
}

TEST(BvhRows, refusesRowsThatAllHaveTheSameWrongLength) {
  EXPECT_EQ(outcome(inLines({4, 4, 4, 4, 4, 4}), 6), rowRefusal("1:1", 4));
  EXPECT_EQ(outcome(inLines({2, 2, 2, 2, 2, 2}), 6), rowRefusal("1:1", 2));
  EXPECT_EQ(outcome(inLines({4}), 1), rowRefusal("1:1", 4));
  EXPECT_EQ(outcome(inLines({2, 2}), 2), rowRefusal("1:1", 2));
  EXPECT_EQ(outcome(inLines({4, 4, 4, 4}), 2), rowRefusal("1:1", 4)) << "a wrong number of frames, too";
}

TEST(BvhRows, refusesLengthsThatAddUpToWholeRows) {
  // A third, a half and twice of what is expected: as many lines as declared frames.
  EXPECT_EQ(outcome(inLines({1, 1, 1, 1, 1, 1}), 6), rowRefusal("1:1", 1));
  EXPECT_EQ(outcome(inLines({6, 6, 6, 6}), 4), rowRefusal("1:1", 6));
  const std::string expectedFour = ", expected 4, one for each channel in HIERARCHY";
  EXPECT_EQ(outcome(inLines({2, 2, 2, 2, 2, 2}), 6, 4), rowRefusal("1:1", 2, expectedFour));
  // One frame more or less than declared changes nothing.
  EXPECT_EQ(outcome(inLines({2, 2, 2, 2, 2, 2, 2}), 6, 4), rowRefusal("1:1", 2, expectedFour));
  EXPECT_EQ(outcome(inLines({2, 2, 2, 2, 2, 2}), 7, 4), rowRefusal("1:1", 2, expectedFour));
  // With twice as many lines as declared frames they are wrapped rows.
  EXPECT_EQ(outcome(inLines({2, 2, 2, 2, 2, 2}), 3, 4), "3 rows");
}

TEST(BvhRows, refusesOneRowOfAWrongLengthByItsLine) {
  EXPECT_EQ(outcome(inLines({3, 3, 2, 3, 3}), 5), rowRefusal("3:1", 2));
  EXPECT_EQ(outcome(inLines({3, 3, 4, 3, 3}), 5), rowRefusal("3:1", 4));
  EXPECT_EQ(outcome(inLines({3, 3, 3, 3, 4}), 5), rowRefusal("5:1", 4));
  EXPECT_EQ(outcome(inLines({2, 3, 3, 3, 3}), 5), rowRefusal("1:1", 2));
  EXPECT_EQ(outcome(inLines({3, 2, 4, 3, 3}), 5), rowRefusal("2:1", 2)) << "what one lacks, the next has";
  EXPECT_EQ(outcome(inLines({3, 1, 2, 3, 3}), 5), rowRefusal("2:1", 1)) << "two that are a row together";
  EXPECT_EQ(outcome(inLines({3, 6, 3}), 3), rowRefusal("2:1", 6));
  EXPECT_EQ(outcome("\n 0 1 2\n\n  3 4\n5 6 7\n", 3), rowRefusal("4:3", 2)) << "blank lines count";
}

TEST(BvhRows, refusesAWrappedRowOfAWrongLength) {
  constexpr std::string_view kTail =
      " lines, expected a row of 3, one for each channel in HIERARCHY, that ends where a line ends";
  EXPECT_EQ(outcome(inLines({2, 1, 2, 2, 2, 1}), 3), "3:1: found 4 numbers in 2" + std::string(kTail));
  EXPECT_EQ(outcome(inLines({1, 1, 3, 3}), 3), "1:1: found 2 numbers in 2" + std::string(kTail));
  EXPECT_EQ(outcome(inLines({1, 1}), 1), "1:1: found 2 numbers in 2" + std::string(kTail));
}

TEST(BvhRows, usesTheWholeRowsAndSaysWhereTheyDifferFromWhatWasDeclared) {
  EXPECT_EQ(outcome(inLines({3, 3}), 3),
            "2 rows; 3:1: 3 frames are declared, 2 complete rows of 3 numbers were found; the complete rows "
            "are used");
  EXPECT_EQ(outcome(inLines({3, 3, 3, 3}), 2),
            "4 rows; 3:1: 2 frames are declared, 4 complete rows of 3 numbers were found; the complete rows "
            "are used");
  EXPECT_EQ(outcome("0 1 2\n3 4 5\n  6 7", 3),
            "2 rows; 3:3: 3 frames are declared, 2 complete rows of 3 numbers and 2 more were found; the "
            "complete rows are used");
  EXPECT_EQ(outcome("0 1 2\n3 4 5\n6 7", 2),
            "2 rows; 3:1: 2 frames are declared, 2 complete rows of 3 numbers and 2 more were found; the "
            "complete rows are used");
  // Far fewer than declared: no more memory is taken than the text can fill.
  EXPECT_EQ(outcome(inLines({3, 3}), 1'000'000).substr(0, 6), "2 rows");
}

TEST(BvhRows, tellsACutFromAWrongLengthWhereAllIsOnOneLine) {
  EXPECT_EQ(outcome(inLines({11}), 4),
            "3 rows; 1:1: 4 frames are declared, 3 complete rows of 3 numbers and 2 more were found; the "
            "complete rows are used");
  EXPECT_EQ(outcome(inLines({13}), 4).substr(0, 6), "4 rows");
  EXPECT_EQ(outcome(inLines({6, 6, 5}), 6).substr(0, 6), "5 rows");
  // Equally many numbers for each declared frame.
  EXPECT_EQ(outcome(inLines({16}), 4), rowRefusal("1:1", 4));
  EXPECT_EQ(outcome(inLines({12}), 6), rowRefusal("1:1", 2));
  EXPECT_EQ(outcome(inLines({17}), 4), rowRefusal("1:1", 17)) << "more rows than declared, and a cut one";
}

TEST(BvhRows, leavesOutTextBehindTheLastFrame) {
  EXPECT_EQ(outcome("0 1 2\n3 4 5\n}\n6 7 8\n", 2),
            "2 rows; 3:1: left out the text behind the last frame, which begins here");
  EXPECT_EQ(outcome("0 1 2\n3 4 5\nHIERARCHY\nROOT hips\n", 2),
            "2 rows; 3:1: left out the text behind the last frame, which begins here");
  EXPECT_EQ(outcome("0 1 2\nend\n", 2), "2:1: found \"end\", expected a channel's value");
  EXPECT_EQ(outcome("0 1 2\n3 4 5 # last\n", 2), "2:7: found \"#\", expected a channel's value");
}

TEST(BvhRows, refusesWhatIsNoNumber) {
  constexpr std::string_view kComma = ", with a decimal point, and blanks between numbers";
  EXPECT_EQ(outcome("0,1,2\n", 1), "1:1: found \"0,1,2\", expected a channel's value" + std::string(kComma));
  EXPECT_EQ(outcome("0, 1, 2\n", 1), "1:1: found \"0,\", expected a channel's value" + std::string(kComma));
  EXPECT_EQ(outcome("0;1;2\n", 1), "1:1: found \"0;1;2\", expected a channel's value");
  for (const char* const text : {"1.#IND", "1.#QNAN", "-1.#INF", "0x1F", "1_000", "--5", "1e", "NULL"}) {
    EXPECT_EQ(outcome(std::string("0 ") + text + " 2\n", 1),
              "1:3: found \"" + std::string(text) + "\", expected a channel's value");
  }
  for (const char* const text : {"nan", "-nan", "inf", "-Infinity", "1e400", "1e10"}) {
    EXPECT_EQ(outcome(std::string("0 ") + text + " 2\n", 1),
              "1:3: found \"" + std::string(text) +
                  "\", expected a channel's value, finite and at most 1e9 in size");
  }
}

}  // namespace
}  // namespace stridegraph
