#include "program/number_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace stridegraph::tools {
namespace {

constexpr NumberRange kMetres{0.05, 5.0, "metres"};
constexpr NumberRange kAbove{0.0, 10.0, "metres", true};
constexpr WholeRange kFrames{2, 120, "frames"};
constexpr WholeRange kAny{0, std::numeric_limits<std::uint64_t>::max(), ""};

TEST(NumberText, takesDecimalNumbersInTheirRange) {
  EXPECT_EQ(*parseNumber("0.05", kMetres), 0.05);
  EXPECT_EQ(*parseNumber("5", kMetres), 5.0);
  EXPECT_EQ(*parseNumber("+1.5e-1", kMetres), 0.15);
  EXPECT_EQ(*parseNumber("1e-300", kAbove), 1e-300);
  EXPECT_EQ(*parseWhole("120", kFrames), 120U);
  EXPECT_EQ(*parseWhole("18446744073709551615", kAny), std::numeric_limits<std::uint64_t>::max());
}

TEST(NumberText, refusesAllElse) {
  for (const char* text :
       {"",       " ",      "1 ",  " 1", "1,5", "nan", "-nan", "inf", "-inf",  "infinity", "0x1p3", "1e999",
        "-1e999", "1e-999", "one", "1m", "--1", "+-1", "1e",   "0",   "-0.05", "5.0001",   "\xff"})
    EXPECT_FALSE(parseNumber(text, kMetres)) << text;
  for (const char* text : {"0", "-0", "-1e-300", "10.01"}) EXPECT_FALSE(parseNumber(text, kAbove)) << text;
  for (const char* text : {"", " 7", "7 ", "+7", "-7", "0x10", "7.0", "1e1", "1", "121",
                           "18446744073709551616", "99999999999999999999999", "\xff"})
    EXPECT_FALSE(parseWhole(text, kFrames)) << text;
  for (const char* text : {"-5", "18446744073709551616", "12345678901234567890123"})
    EXPECT_FALSE(parseWhole(text, kAny)) << text;
}

TEST(NumberText, saysWhatItFoundAndExpected) {
  EXPECT_EQ(parseNumber("nan", kMetres).error().message,
            "found nan, expected a number from 0.05 to 5 metres");
  EXPECT_EQ(parseNumber("", kAbove).error().message, "found \"\", expected a number above 0 to 10 metres");
  EXPECT_EQ(parseWhole("-5", kFrames).error().message,
            "found -5, expected a whole number from 2 to 120 frames");
  EXPECT_EQ(parseWhole("-5", kFrames).error().code, ErrorCode::kInvalidArgument);
}

TEST(NumberText, writesNumbersAsPeopleDo) {
  EXPECT_EQ(plainNumber(0.05), "0.05");
  EXPECT_EQ(plainNumber(86'400'000.0), "86400000");
  EXPECT_EQ(plainNumber(1e6), "1000000");
}

}  // namespace
}  // namespace stridegraph::tools
