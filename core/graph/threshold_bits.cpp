#include "graph/threshold_bits.h"

#if defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>

#include "base/bits.h"
#include "base/wide.h"

namespace stridegraph {
namespace {

using WordCells = std::array<std::uint32_t, ThresholdBits::kWordBits>;

#if defined(__wasm_simd128__)

v128_t underFour(const std::uint32_t* micrometres, v128_t limit) {
  return wasm_i32x4_le(wasm_v128_load(micrometres), limit);
}

/// WebAssembly has an instruction that collects bits; without it this would be the slowest part of the
/// search.
std::uint64_t wordOf(const std::uint32_t* micrometres, std::uint32_t limit) {
  constexpr std::size_t kAtOnce = 16;
  const v128_t limits = wasm_i32x4_splat(static_cast<std::int32_t>(limit));
  std::uint64_t word = 0;
  for (std::size_t c = 0; c < ThresholdBits::kWordBits; c += kAtOnce, micrometres += kAtOnce) {
    const v128_t first =
        wasm_i16x8_narrow_i32x4(underFour(micrometres, limits), underFour(micrometres + 4, limits));
    const v128_t second =
        wasm_i16x8_narrow_i32x4(underFour(micrometres + 8, limits), underFour(micrometres + 12, limits));
    const auto bits = static_cast<std::uint16_t>(wasm_i8x16_bitmask(wasm_i8x16_narrow_i16x8(first, second)));
    word |= std::uint64_t{bits} << c;
  }
  return word;
}

#else

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
  const auto bytes = bitCast<std::array<std::uint64_t, ThresholdBits::kWordBits / kByteBits> >(under);
  std::uint64_t word = 0;
  for (std::size_t b = 0; b < bytes.size(); ++b) word |= bitsOfBytes(bytes[b]) << (b * kByteBits);
  return word;
}

#endif

STRIDEGRAPH_WIDE std::uint64_t wordOfWide(const std::uint32_t* micrometres, std::uint32_t limit) {
  return wordOf(micrometres, limit);
}

std::uint64_t underLimit(const std::uint32_t* micrometres, std::uint32_t limit) {
  return hasWideRegisters() ? wordOfWide(micrometres, limit) : wordOf(micrometres, limit);
}

/// The columns of a word moved on by less than a word, with what comes in from the word before.
STRIDEGRAPH_INLINE std::uint64_t movedOn(const std::uint64_t* word, std::size_t columns) {
  // In two steps, since none may be as long as the word.
  return word[0] << columns | word[-1] >> 1 >> (ThresholdBits::kWordBits - 1 - columns);
}

}  // namespace

BitLine::BitLine(const WarpedLine& line) {
  std::vector<CellBack> cells = line.cells;
  std::sort(cells.begin(), cells.end(), [](const CellBack& a, const CellBack& b) {
    return std::tie(a.rows, a.columns) < std::tie(b.rows, b.columns);
  });
  for (std::size_t begin = 0; begin < cells.size();) {
    std::size_t end = begin + 1;
    while (end < cells.size() && cells[end].rows == cells[end - 1].rows + 1 &&
           cells[end].columns == cells[end - 1].columns + 1)
      ++end;
    cover(cells[begin], end - begin);
    begin = end;
  }
}

void BitLine::cover(const CellBack& last, std::size_t length) {
  std::size_t logarithm = 0;
  while (logarithm + 1 < kLengths && std::size_t{2} << logarithm <= length) ++logarithm;
  const std::size_t piece = std::size_t{1} << logarithm;
  // The last piece may overlap the one before.
  for (std::size_t done = 0; done < length; done += piece) {
    const std::size_t at = std::min(done, length - piece);
    const std::size_t columns = last.columns + at;
    pieces_.push_back({(last.rows + at) * kLengths + logarithm, columns / ThresholdBits::kWordBits,
                       columns % ThresholdBits::kWordBits});
  }
}

void ThresholdBits::restart(std::size_t rows, std::size_t columns, std::size_t reach) {
  padding_ = reach / kWordBits + 1;
  const std::size_t width = padding_ + wordsFor(columns);
  rows_.restart(rows, BitLine::kLengths * width);
  recent_.resize(rows * BitLine::kLengths);
  for (std::size_t k = 0; k < recent_.size(); ++k)
    recent_[k] = rows_.back(k / BitLine::kLengths) + k % BitLine::kLengths * width + padding_;
}

void ThresholdBits::addRow(std::span<const std::uint32_t> micrometres, std::size_t firstColumn,
                           std::uint32_t limit) {
  // The oldest row becomes the newest.
  std::array<std::uint64_t*, BitLine::kLengths> oldest;
  std::copy(recent_.end() - BitLine::kLengths, recent_.end(), oldest.begin());
  std::copy_backward(recent_.begin(), recent_.end() - BitLine::kLengths, recent_.end());
  std::copy(oldest.begin(), oldest.end(), recent_.begin());
  std::uint64_t* words = recent_[0];
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
  findPieces(wordsFor(micrometres.size()));
}

void ThresholdBits::findPieces(std::size_t words) {
  for (std::size_t k = 0; k + 1 < BitLine::kLengths; ++k) {
    const std::size_t half = std::size_t{1} << k;
    // Two pieces of half the length, one behind the other; a ring too short for them is never asked.
    const std::size_t before = half * BitLine::kLengths + k;
    if (before >= recent_.size()) return;
    const std::uint64_t* last = recent_[k];
    const std::uint64_t* earlier = recent_[before];
    std::uint64_t* both = recent_[k + 1];
    for (std::size_t w = 0; w < words; ++w) both[w] = last[w] & movedOn(earlier + w, half);
  }
}

std::uint64_t ThresholdBits::lineEnds(const BitLine& line, std::size_t word) const {
  std::uint64_t under = ~std::uint64_t{0};
  for (const BitLine::Piece& piece : line.pieces_) {
    under &= movedOn(recent_[piece.row] + word - piece.words, piece.bits);
    if (under == 0) break;
  }
  return under;
}

}  // namespace stridegraph
