#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "graph/recent_rows.h"
#include "graph/warped_lines.h"

namespace stridegraph {

/// A line as ThresholdBits looks for it.
class BitLine {
 public:
  explicit BitLine(const WarpedLine& line);

 private:
  friend class ThresholdBits;
  struct Cell {
    std::uint32_t rows = 0;
    std::uint32_t words = 0;
    std::uint32_t bits = 0;
  };
  /// Tried at once, without a glance in between.
  static constexpr std::size_t kCellsAtOnce = 4;

  std::vector<Cell> cells_;  ///< As many as a multiple of kCellsAtOnce; the first fills up.
};

/// Which cells of the last rows of a similarity matrix are under the threshold, a bit each, so that a line is
/// tried at 64 columns at once and most of the matrix is done with after a glance.
class ThresholdBits {
 public:
  static constexpr std::size_t kWordBits = 64;
  static std::size_t wordsFor(std::size_t columns) { return columns / kWordBits + 1; }

  /// Forgets all and keeps `rows` rows of `columns` cells from now on; lines reach at most `reach` columns
  /// back.
  void restart(std::size_t rows, std::size_t columns, std::size_t reach);

  /// The next row; cells left of `firstColumn` count as over the limit. Distances and limit are below 2^31.
  void addRow(std::span<const std::uint32_t> micrometres, std::size_t firstColumn, std::uint32_t limit);
  /// Of the last row, columns 64 word and on: the lowest bit is the first column.
  std::uint64_t word(std::size_t word) const { return recent_[0][word]; }
  /// The same columns, those at which a line that ends in the last row is under the threshold from end to
  /// end.
  std::uint64_t lineEnds(const BitLine& line, std::size_t word) const;

 private:
  std::size_t padding_ = 0;  ///< Words of zeros before each row.
  RecentRows<std::uint64_t> rows_;
  std::vector<const std::uint64_t*> recent_;  ///< Where the words of the rows begin, the last row first.
};

}  // namespace stridegraph
