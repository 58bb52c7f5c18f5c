#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "graph/warped_lines.h"

namespace stridegraph {

/// Which cells of the last rows of a similarity matrix are under the threshold, a bit each, so that a line is
/// tried at 64 columns at once and most of the matrix is done with after a glance.
class ThresholdBits {
 public:
  /// Keeps `rows` rows of `columns` cells; lines reach at most `reach` columns back.
  ThresholdBits(std::size_t rows, std::size_t columns, std::size_t reach);

  /// The next row; cells left of `firstColumn` count as over the limit.
  void addRow(std::span<const std::uint32_t> micrometres, std::size_t firstColumn, std::uint32_t limit);
  /// Appends the columns at which a line that ends in the last row is under the threshold from end to end.
  void findLines(const WarpedLine& line, std::vector<std::size_t>& lastColumns) const;

 private:
  std::size_t columns_;
  std::size_t padding_;  ///< Words of zeros before each row.
  std::vector<std::vector<std::uint64_t>> rows_;
  std::size_t count_ = 0;
};

}  // namespace stridegraph
