#include "graph/warped_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

namespace stridegraph {
namespace {

TEST(WarpedLines, haveTheStepsAsTheirMeanAndKeepToTheRatio) {
  const std::vector<WarpedLine> lines = warpedLines(12, 1.5);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(std::pair(lines[0].rowSpan, lines[0].columnSpan), std::pair(std::size_t{11}, std::size_t{13}));
  EXPECT_EQ(std::pair(lines[1].rowSpan, lines[1].columnSpan), std::pair(std::size_t{13}, std::size_t{11}));
  EXPECT_EQ(std::pair(lines[2].rowSpan, lines[2].columnSpan), std::pair(std::size_t{10}, std::size_t{14}));
  EXPECT_EQ(std::pair(lines[3].rowSpan, lines[3].columnSpan), std::pair(std::size_t{14}, std::size_t{10}));
  EXPECT_EQ(lines[0].lean(), 1U);
  EXPECT_EQ(lines[3].lean(), 2U);
}

TEST(WarpedLines, reachTwiceTheLengthAtARatioOfTwoAndVanishAtOne) {
  EXPECT_EQ(warpedLines(12, 2.0).back().rowSpan, 16U);
  EXPECT_EQ(warpedLines(12, 2.0).back().columnSpan, 8U);
  EXPECT_TRUE(warpedLines(12, 1.0).empty());
  EXPECT_TRUE(warpedLines(1, 2.0).empty());
}

TEST(WarpedLines, goThroughACellForEachStepOfTheLongerSpanWithoutGoingBack) {
  for (const WarpedLine& line : warpedLines(30, 2.0)) {
    const std::size_t steps = std::max(line.rowSpan, line.columnSpan);
    std::set<std::pair<std::size_t, std::size_t>> cells;
    for (const CellBack& cell : line.cells) cells.insert({cell.rows, cell.columns});
    ASSERT_EQ(line.cells.size(), steps + 1);
    ASSERT_EQ(cells.size(), steps + 1);
    EXPECT_EQ(*cells.begin(), std::pair(std::size_t{0}, std::size_t{0}));
    EXPECT_EQ(*cells.rbegin(), std::pair(line.rowSpan, line.columnSpan));
    for (auto cell = cells.begin(), next = std::next(cell); next != cells.end(); ++cell, ++next) {
      EXPECT_LE(next->first - cell->first, 1U);
      EXPECT_LE(next->second - cell->second, 1U);
    }
  }
}

TEST(DiagonalLine, goesOneColumnOnForEachRow) {
  const WarpedLine line = diagonalLine(12);
  EXPECT_EQ(line.rowSpan, 12U);
  EXPECT_EQ(line.columnSpan, 12U);
  EXPECT_EQ(line.lean(), 0U);
  ASSERT_EQ(line.cells.size(), 13U);
  std::set<std::size_t> rows;
  for (const CellBack& cell : line.cells) {
    EXPECT_EQ(cell.rows, cell.columns);
    rows.insert(cell.rows);
  }
  EXPECT_EQ(rows.size(), 13U);
  EXPECT_EQ(*rows.rbegin(), 12U);
}

}  // namespace
}  // namespace stridegraph
