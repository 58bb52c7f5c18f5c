#include "motion/bvh_frame_time.h"

#include <gtest/gtest.h>

namespace stridegraph {
namespace {

/// "rate" or "rate; warning" of a frame time, or why it is refused.
std::string outcome(std::string_view text) {
  BvhScanner scanner(text, "");
  const Result<BvhFrameTime> time = parseBvhFrameTime(scanner);
  if (!time) return describe(time.error());
  char rate[32];
  std::snprintf(rate, sizeof(rate), "%.6g", time->framesPerSecond);
  if (!time->warning) return rate;
  EXPECT_EQ(time->warning->topic, WarningTopic::kTime);
  return std::string(rate) + "; " + describe(*time->warning);
}

TEST(BvhFrameTime, isSecondsUpToOne) {
  EXPECT_EQ(outcome("0.0333333"), "30");
  EXPECT_EQ(outcome("0.033"), "30");
  EXPECT_EQ(outcome("0.0083333"), "120");
  EXPECT_EQ(outcome("0.04166667"), "24");
  EXPECT_EQ(outcome("0.0333667"), "29.97");
  EXPECT_EQ(outcome("1"), "1");
  EXPECT_EQ(outcome("1.0"), "1");
  EXPECT_EQ(outcome("0.0001"), "10000");
}

TEST(BvhFrameTime, isMillisecondsWhereItCanBeNothingElse) {
  EXPECT_EQ(outcome("33.333333"),
            "30; 1:1: found a frame time of 33.333333 and read it as milliseconds: 30 frames a second");
  for (const auto& [text, rate] : {std::pair{"33.3", "30"},
                                   {"33.33", "30"},
                                   {"33.34", "30"},
                                   {"33", "30"},
                                   {"33.3333349227905", "30"},
                                   {"16.66", "60"},
                                   {"16.6667", "60"},
                                   {"17", "60"},
                                   {"8.33333", "120"},
                                   {"41.6667", "24"},
                                   {"41.7083", "23.976"},
                                   {"33.3667", "29.97"},
                                   {"16.6833", "59.9401"},
                                   {"66.6667", "15"},
                                   {"6.94444", "144"},
                                   {"11.1111", "90"},
                                   {"13.3333", "75"},
                                   {"20.8333", "48"},
                                   {"83.3333", "12"}}) {
    EXPECT_TRUE(outcome(text).starts_with(std::string(rate) + "; ")) << text << ": " << outcome(text);
  }
}

TEST(BvhFrameTime, isRefusedWhereItMayBeARateOrMilliseconds) {
  EXPECT_EQ(outcome("30"),
            "1:1: found a frame time of 30, expected the seconds from one frame to the next, 0.0001 to 1: "
            "0.03333333 if it is frames a second, 0.03 if it is milliseconds");
  for (const char* const text : {"24", "25", "29.97", "30.000000", "40", "40.0", "50", "59.94", "60", "100",
                                 "119.88", "120", "240", "1000", "2", "34.7", "500"}) {
    EXPECT_NE(outcome(text).find("if it is milliseconds"), std::string::npos)
        << text << ": " << outcome(text);
  }
}

TEST(BvhFrameTime, isRefusedBeyondItsLimits) {
  for (const char* const text :
       {"0", "-0", "0.0", "-0.0333333", "-30", "1e-9", "0.00003333", "33333.333", "333333", "1e9"}) {
    EXPECT_EQ(outcome(text), "1:1: found a frame time of " + std::string(text) +
                                 ", expected the seconds from one frame to the next, 0.0001 to 1");
  }
  EXPECT_EQ(outcome("nan"),
            "1:1: found \"nan\", expected the frame time in seconds, finite and at most 1e9 in size");
  EXPECT_EQ(outcome("1/30"), "1:1: found \"1/30\", expected the frame time in seconds");
  EXPECT_EQ(outcome("0,0333"),
            "1:1: found \"0,0333\", expected the frame time in seconds, with a decimal point, and blanks "
            "between numbers");
  EXPECT_EQ(outcome(""), "1:1: found the end of the text, expected the frame time in seconds");
}

}  // namespace
}  // namespace stridegraph
