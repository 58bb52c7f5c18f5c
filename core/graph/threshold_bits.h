#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "graph/recent_rows.h"
#include "graph/warped_lines.h"

namespace stridegraph {

/// A line as ThresholdBits looks for it: pieces of diagonals, each of 1, 2 or 4 cells, which together cover
/// all of its cells.
class BitLine {
 public:
  explicit BitLine(const WarpedLine& line);

 private:
  friend class ThresholdBits;
  /// Lengths of pieces are powers of two up to 2^(kLengths - 1).
  static constexpr std::size_t kLengths = 3;
  /// Where a piece ends, counted back from the line's last cell.
  struct Piece {
    std::size_t row = 0;  ///< kLengths times the rows, and the logarithm of the length.
    std::size_t words = 0;
    std::size_t bits = 0;
  };
  void cover(const CellBack& last, std::size_t length);

  std::vector<Piece> pieces_;
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
  void findPieces(std::size_t words);

  std::size_t padding_ = 0;  ///< Words of zeros before each row.
  /// A row for each length of a piece: the cells at which such a piece ends, under the limit from end to end.
  RecentRows<std::uint64_t> rows_;
  std::vector<std::uint64_t*> recent_;  ///< Where the words of these rows begin, the last row first.
};

}  // namespace stridegraph
