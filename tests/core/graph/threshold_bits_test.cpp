#include "graph/threshold_bits.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "math/random.h"

namespace stridegraph {
namespace {

/// The columns at which a line that ends in the last row is under the limit.
std::vector<std::size_t> lineEnds(const ThresholdBits& bits, const WarpedLine& line, std::size_t columns) {
  std::vector<std::size_t> ends;
  for (std::size_t c = 0; c < columns; ++c) {
    const std::uint64_t word = bits.lineEnds(BitLine(line), c / ThresholdBits::kWordBits);
    if ((word >> c % ThresholdBits::kWordBits & 1U) != 0) ends.push_back(c);
  }
  return ends;
}

TEST(ThresholdBits, findEveryLineUnderTheLimitAndNoOther) {
  constexpr std::uint32_t kLimit = 100;
  constexpr std::size_t kColumns = 200;
  Random random(41);
  // Long enough that lines reach back over more than one word of bits.
  for (const std::size_t steps : {std::size_t{5}, std::size_t{12}, std::size_t{70}}) {
    const std::vector<WarpedLine> lines = warpedLines(steps, 2.0);
    ThresholdBits bits;
    bits.restart(2 * steps, kColumns, 2 * steps);
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
        const std::vector<std::size_t> found = lineEnds(bits, line, kColumns);
        ASSERT_EQ(found, expected);
        count += found.size();
      }
    }
    EXPECT_GT(count, 100U);
  }
}

TEST(ThresholdBits, takeCellsLeftOfTheFirstColumnForOverTheLimit) {
  const WarpedLine line = warpedLines(3, 2.0).front();
  ThresholdBits bits;
  bits.restart(5, 20, 5);
  for (std::size_t r = 0; r < 4; ++r) bits.addRow(std::vector<std::uint32_t>(20, 0), 10, 5);
  const std::vector<std::size_t> found = lineEnds(bits, line, 20);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front(), 10 + line.columnSpan);
}

}  // namespace
}  // namespace stridegraph
