#include "graph/threshold_bits.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "math/random.h"

namespace stridegraph {
namespace {

TEST(ThresholdBits, findEveryLineUnderTheLimitAndNoOther) {
  constexpr std::uint32_t kLimit = 100;
  constexpr std::size_t kColumns = 200;
  Random random(41);
  // Long enough that lines reach back over more than one word of bits.
  for (const std::size_t steps : {std::size_t{5}, std::size_t{12}, std::size_t{70}}) {
    const std::vector<WarpedLine> lines = warpedLines(steps, 2.0);
    ThresholdBits bits(2 * steps, kColumns, 2 * steps);
    std::vector<std::vector<std::uint32_t>> matrix;
    std::size_t count = 0;
    for (std::size_t r = 0; r < 3 * steps; ++r) {
      std::vector<std::uint32_t>& row = matrix.emplace_back(kColumns);
      for (std::uint32_t& cell : row) cell = random.below(1000) < 990 ? kLimit : kLimit + 1;
      bits.addRow(row, 0, kLimit);
      for (const WarpedLine& line : lines) {
        std::vector<std::size_t> expected;
        for (std::size_t c = line.columnSpan; c < kColumns && r >= line.rowSpan; ++c) {
          if (std::all_of(line.cells.begin(), line.cells.end(), [&](const CellBack& cell) {
                return matrix[r - cell.rows][c - cell.columns] <= kLimit;
              }))
            expected.push_back(c);
        }
        std::vector<std::size_t> found;
        bits.findLines(line, found);
        ASSERT_EQ(found, expected);
        count += found.size();
      }
    }
    EXPECT_GT(count, 100U);
  }
}

TEST(ThresholdBits, takeCellsLeftOfTheFirstColumnForOverTheLimit) {
  const WarpedLine line = warpedLines(3, 2.0).front();
  ThresholdBits bits(5, 20, 5);
  for (std::size_t r = 0; r < 4; ++r) bits.addRow(std::vector<std::uint32_t>(20, 0), 10, 5);
  std::vector<std::size_t> found;
  bits.findLines(line, found);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front(), 10 + line.columnSpan);
}

}  // namespace
}  // namespace stridegraph
