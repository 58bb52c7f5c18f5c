#include "program/progress_text.h"

#include <gtest/gtest.h>

#include <vector>

namespace stridegraph::tools {
namespace {

/// All that is written when told of even progress ten times a second.
std::vector<std::string> written(ProgressStyle style, double seconds) {
  ProgressText text("building", style);
  std::vector<std::string> all;
  const int steps = static_cast<int>(10.0 * seconds);
  for (int i = 0; i <= steps; ++i) {
    if (auto line = text.at(static_cast<double>(i) / steps, 100.0 * i)) all.push_back(*line);
  }
  return all;
}

TEST(ProgressText, saysNothingOfWorkThatIsSoonDone) {
  EXPECT_TRUE(written(ProgressStyle::kTerminal, 0.4).empty());
  EXPECT_TRUE(written(ProgressStyle::kLines, 9.9).empty());
  EXPECT_TRUE(written(ProgressStyle::kNone, 1000.0).empty());
}

TEST(ProgressText, writesOneLineOverOnATerminal) {
  const std::vector<std::string> all = written(ProgressStyle::kTerminal, 40.0);
  ASSERT_GT(all.size(), 300U);
  EXPECT_EQ(all.front(), "\r\x1b[Kbuilding: 1 %");
  EXPECT_EQ(all[195], "\r\x1b[Kbuilding: 50 %, about 20 s left");
  for (const std::string& text : all) EXPECT_EQ(text.find('\n'), std::string::npos);
}

TEST(ProgressText, writesALineNowAndThenElsewhere) {
  EXPECT_EQ(
      written(ProgressStyle::kLines, 40.0),
      (std::vector<std::string>{
          "building: 25 % after 10 s, about 30 s left\n", "building: 50 % after 20 s, about 20 s left\n",
          "building: 75 % after 30 s, about 10 s left\n", "building: 100 % after 40 s\n"}));
}

TEST(ProgressText, clearsItsLineOnce) {
  ProgressText text("building", ProgressStyle::kTerminal);
  EXPECT_EQ(text.clearing(), "") << "nothing shown yet";
  EXPECT_TRUE(text.at(0.5, 600.0));
  EXPECT_EQ(text.clearing(), "\r\x1b[K");
  EXPECT_EQ(text.clearing(), "");
  ProgressText lines("building", ProgressStyle::kLines);
  EXPECT_TRUE(lines.at(0.5, 20'000.0));
  EXPECT_EQ(lines.clearing(), "");
}

TEST(ProgressText, keepsSharesWithinBounds) {
  ProgressText text("building", ProgressStyle::kTerminal);
  EXPECT_EQ(text.at(7.0, 1000.0), "\r\x1b[Kbuilding: 100 %");
  EXPECT_EQ(text.at(-1.0, 2000.0), "\r\x1b[Kbuilding: 0 %");
}

TEST(TimeLeft, isJudgedByThePaceSoFar) {
  EXPECT_EQ(timeLeft(0.25, 60'000.0), "about 3 min 0 s left");
  EXPECT_EQ(timeLeft(0.5, 1999.0), "") << "too early";
  EXPECT_EQ(timeLeft(0.01, 60'000.0), "") << "too little";
  EXPECT_EQ(timeLeft(1.0, 60'000.0), "");
  EXPECT_EQ(timeLeft(0.999, 2000.0), "about 1 s left");
}

}  // namespace
}  // namespace stridegraph::tools
