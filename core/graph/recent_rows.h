#pragma once

#include <cstddef>
#include <vector>

namespace stridegraph {

/// The last rows of a matrix that is shown row by row.
template <typename Cell>
class RecentRows {
 public:
  /// `count` >= 1 rows of `width` cells each, all zero, in the memory of those before.
  void restart(std::size_t count, std::size_t width) {
    cells_.assign(count * width, Cell{});
    count_ = count;
    width_ = width;
    newest_ = 0;
  }
  /// Room for the next row; it takes the place of the oldest and still holds its cells.
  Cell* push() {
    newest_ = newest_ + 1 == count_ ? 0 : newest_ + 1;
    return back(0);
  }
  /// The row pushed `rows` < count rows before the last.
  const Cell* back(std::size_t rows) const { return cells_.data() + indexOf(rows) * width_; }
  Cell* back(std::size_t rows) { return cells_.data() + indexOf(rows) * width_; }
  std::size_t count() const { return count_; }

 private:
  std::size_t indexOf(std::size_t rows) const {
    return newest_ >= rows ? newest_ - rows : newest_ + count_ - rows;
  }

  std::vector<Cell> cells_;
  std::size_t count_ = 0;
  std::size_t width_ = 0;
  std::size_t newest_ = 0;
};

}  // namespace stridegraph
