#include "graph/threshold_bits.h"

#include <algorithm>
#include <array>
#include <limits>

#include "base/bits.h"
#include "base/wide.h"

namespace stridegraph {
namespace {

using WordCells = std::array<std::uint32_t, ThresholdBits::kWordBits>;

constexpr std::size_t kByteBits = 8;

/// One bit for each byte of eight, which are 0 or 1 each: a product that moves the lowest bit of byte k to
/// bit 56 + k.
STRIDEGRAPH_INLINE std::uint64_t bitsOfBytes(std::uint64_t bytes) {
  return bytes * 0x0102'0408'1020'4080U >> 56;
}

STRIDEGRAPH_INLINE std::uint64_t wordOf(const std::uint32_t* micrometres, std::uint32_t limit) {
  std::array<std::uint8_t, ThresholdBits::kWordBits> under;
  // Signed numbers, since SSE2 compares no others.
  const auto signedLimit = static_cast<std::int32_t>(limit);
  for (std::size_t c = 0; c < under.size(); ++c)
    under[c] = static_cast<std::int32_t>(micrometres[c]) <= signedLimit ? 1 : 0;
  const auto bytes = bitCast<std::array<std::uint64_t, ThresholdBits::kWordBits / kByteBits>>(under);
  std::uint64_t word = 0;
  for (std::size_t b = 0; b < bytes.size(); ++b) word |= bitsOfBytes(bytes[b]) << (b * kByteBits);
  return word;
}

STRIDEGRAPH_WIDE std::uint64_t wordOfWide(const std::uint32_t* micrometres, std::uint32_t limit) {
  return wordOf(micrometres, limit);
}

std::uint64_t underLimit(const std::uint32_t* micrometres, std::uint32_t limit) {
  return hasWideRegisters() ? wordOfWide(micrometres, limit) : wordOf(micrometres, limit);
}

}  // namespace

BitLine::BitLine(const WarpedLine& line) {
  constexpr std::size_t kWordBits = ThresholdBits::kWordBits;
  for (const CellBack& cell : line.cells)
    cells_.push_back({static_cast<std::uint32_t>(cell.rows),
                      static_cast<std::uint32_t>(cell.columns / kWordBits),
                      static_cast<std::uint32_t>(cell.columns % kWordBits)});
  while (cells_.size() % kCellsAtOnce != 0) cells_.push_back(Cell{cells_.front()});
}

void ThresholdBits::restart(std::size_t rows, std::size_t columns, std::size_t reach) {
  padding_ = reach / kWordBits + 1;
  rows_.restart(rows, padding_ + wordsFor(columns));
  recent_.resize(rows);
  for (std::size_t k = 0; k < rows; ++k) recent_[k] = rows_.back(k) + padding_;
}

void ThresholdBits::addRow(std::span<const std::uint32_t> micrometres, std::size_t firstColumn,
                           std::uint32_t limit) {
  std::uint64_t* words = rows_.push() + padding_;
  std::copy_backward(recent_.begin(), recent_.end() - 1, recent_.end());
  recent_[0] = words;
  for (std::size_t begin = 0; begin < micrometres.size(); begin += kWordBits) {
    std::uint64_t& word = words[begin / kWordBits];
    word = 0;
    if (begin + kWordBits <= firstColumn) continue;
    if (begin + kWordBits <= micrometres.size()) {
      word = underLimit(micrometres.data() + begin, limit);
    } else {
      WordCells cells;
      cells.fill(std::numeric_limits<std::int32_t>::max());
      std::copy(micrometres.begin() + static_cast<std::ptrdiff_t>(begin), micrometres.end(), cells.begin());
      word = underLimit(cells.data(), limit);
    }
    if (begin < firstColumn) word &= ~std::uint64_t{0} << (firstColumn - begin);
  }
}

std::uint64_t ThresholdBits::lineEnds(const BitLine& line, std::size_t word) const {
  std::uint64_t under = ~std::uint64_t{0};
  for (std::size_t k = 0; k < line.cells_.size() && under != 0; k += BitLine::kCellsAtOnce) {
    for (std::size_t i = k; i < k + BitLine::kCellsAtOnce; ++i) {
      const BitLine::Cell& cell = line.cells_[i];
      const std::uint64_t* words = recent_[cell.rows] + word - cell.words;
      // In two steps, since none may be as long as the word.
      under &= words[0] << cell.bits | words[-1] >> 1 >> (kWordBits - 1 - cell.bits);
    }
  }
  return under;
}

}  // namespace stridegraph
