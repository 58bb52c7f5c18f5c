#include "graph/threshold_bits.h"

#include <algorithm>
#include <bit>

namespace stridegraph {
namespace {

constexpr std::size_t kWordBits = 64;

}  // namespace

ThresholdBits::ThresholdBits(std::size_t rows, std::size_t columns, std::size_t reach)
    : columns_(columns),
      padding_(reach / kWordBits + 1),
      rows_(rows, std::vector<std::uint64_t>(padding_ + columns / kWordBits + 1, 0)) {}

void ThresholdBits::addRow(std::span<const std::uint32_t> micrometres, std::size_t firstColumn,
                           std::uint32_t limit) {
  std::uint64_t* words = rows_[count_++ % rows_.size()].data() + padding_;
  for (std::size_t begin = 0; begin < columns_; begin += kWordBits) {
    const std::size_t end = std::min(begin + kWordBits, columns_);
    std::uint64_t word = 0;
    for (std::size_t c = std::max(begin, firstColumn); c < end; ++c)
      word |= std::uint64_t{micrometres[c] <= limit} << (c - begin);
    words[begin / kWordBits] = word;
  }
}

void ThresholdBits::findLines(const WarpedLine& line, std::vector<std::size_t>& lastColumns) const {
  if (count_ <= line.rowSpan) return;
  const std::size_t lastRow = count_ - 1;
  for (std::size_t begin = 0; begin < columns_; begin += kWordBits) {
    std::uint64_t under = ~std::uint64_t{0};
    for (const CellBack& cell : line.cells) {
      const std::uint64_t* words = rows_[(lastRow - cell.rows) % rows_.size()].data() + padding_ +
                                   begin / kWordBits - cell.columns / kWordBits;
      const std::size_t shift = cell.columns % kWordBits;
      under &= shift == 0 ? words[0] : words[0] << shift | words[-1] >> (kWordBits - shift);
      if (under == 0) break;
    }
    for (; under != 0; under &= under - 1)
      lastColumns.push_back(begin + static_cast<std::size_t>(std::countr_zero(under)));
  }
}

}  // namespace stridegraph
