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

void ThresholdBits::restart(std::size_t rows, std::size_t columns, std::size_t reach) {
  padding_ = reach / kWordBits + 1;
  rows_.restart(rows, padding_ + wordsFor(columns));
}

void ThresholdBits::addRow(std::span<const std::uint32_t> micrometres, std::size_t firstColumn,
                           std::uint32_t limit) {
  std::uint64_t* words = rows_.push() + padding_;
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

std::uint64_t ThresholdBits::lineEnds(const WarpedLine& line, std::size_t word) const {
  std::uint64_t under = ~std::uint64_t{0};
  for (const CellBack& cell : line.cells) {
    const std::uint64_t* words = rows_.back(cell.rows) + padding_ + word - cell.columns / kWordBits;
    const std::size_t shift = cell.columns % kWordBits;
    under &= shift == 0 ? words[0] : words[0] << shift | words[-1] >> (kWordBits - shift);
    if (under == 0) break;
  }
  return under;
}

}  // namespace stridegraph
