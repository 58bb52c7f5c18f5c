#include "graph/valleys.h"

#include <algorithm>
#include <array>
#include <bit>
#include <tuple>

#include "base/check.h"
#include "base/wide.h"
#include "graph/similarity.h"

namespace stridegraph {
namespace {

std::size_t apart(std::size_t a, std::size_t b) {
  return a > b ? a - b : b - a;
}

/// So that the sum of a line under the threshold fits 32 bits, however long it is: 8 m.
constexpr std::uint32_t kLargestLimit = 8'000'000;
constexpr std::size_t kMostFrames = 400;
static_assert(std::uint64_t{kLargestLimit} * (4 * kMostFrames / 3 + 1) < std::uint64_t{1} << 32);
static_assert(std::uint64_t{kFarMicrometres} * kMostFrames < std::uint64_t{1} << 32);

constexpr std::size_t kWordBits = ThresholdBits::kWordBits;

/// The column of the lowest bit of a word.
std::size_t columnOf(std::size_t word, std::uint64_t bits) {
  return word * kWordBits + static_cast<std::size_t>(std::countr_zero(bits));
}

/// The bits of a word that stand for `column` and those after it.
std::uint64_t bitsFrom(std::size_t column, std::size_t word) {
  const std::size_t first = word * kWordBits;
  if (column <= first) return ~std::uint64_t{0};
  return column - first < kWordBits ? ~std::uint64_t{0} << (column - first) : 0;
}

/// Columns begin..end of a new row of sums along diagonals. Borders and rows before the first hold zeros, so
/// that no cell is special; unsigned, so that cells left of what is valid may hold anything.
struct SumRow {
  const std::uint32_t* entering = nullptr;
  const std::uint32_t* leaving = nullptr;
  const std::uint32_t* before = nullptr;
  std::uint32_t* stored = nullptr;  ///< Keeps what enters, until it leaves.
  std::uint32_t* sums = nullptr;
  std::size_t begin = 0;
  std::size_t end = 0;
};

STRIDEGRAPH_INLINE void sumColumns(const SumRow& row) {
  const std::uint32_t* entering = row.entering;
  const std::uint32_t* leaving = row.leaving;
  const std::uint32_t* before = row.before;
  std::uint32_t* __restrict stored = row.stored;
  std::uint32_t* __restrict sums = row.sums;
  const std::size_t end = row.end;
  for (std::size_t c = row.begin; c < end; ++c) {
    stored[c] = entering[c];
    sums[c] = before[c] + entering[c] - leaving[c];
  }
}

STRIDEGRAPH_WIDE void sumWide(const SumRow& row) {
  sumColumns(row);
}

/// Sums of lines that end in columns beside one another: where one is under the threshold, so are others.
constexpr std::size_t kClump = 8;
using ClumpSums = std::array<std::uint32_t, kClump>;

STRIDEGRAPH_INLINE ClumpSums clumpSums(std::span<const std::uint32_t* const> cells, std::size_t column) {
  ClumpSums sums{};
  for (const std::uint32_t* cell : cells) {
    for (std::size_t k = 0; k < kClump; ++k) sums[k] += cell[column + k];
  }
  return sums;
}

STRIDEGRAPH_WIDE ClumpSums clumpSumsWide(std::span<const std::uint32_t* const> cells, std::size_t column) {
  return clumpSums(cells, column);
}

ClumpSums sumClump(std::span<const std::uint32_t* const> cells, std::size_t column) {
  return hasWideRegisters() ? clumpSumsWide(cells, column) : clumpSums(cells, column);
}

double metresOf(std::uint64_t sumMicrometres, std::uint64_t cells) {
  return static_cast<double>(sumMicrometres) / static_cast<double>(cells) / kMicrometresPerMetre;
}

}  // namespace

bool ValleyFinder::Leaning::precedes(const Leaning& other) const {
  const std::uint64_t own = sum * other.cells();
  const std::uint64_t others = other.sum * cells();
  if (own != others) return own < others;
  const auto place = [](const Leaning& l) {
    return std::tuple(l.line->lean(), l.middleRow2, l.middleColumn2, l.line->rowSpan);
  };
  return place(*this) < place(other);
}

ValleyFinder::ValleyFinder(const ValleyParams& params)
    : params_(params),
      limitMicrometres_(limitMicrometres(params.thresholdMetres)),
      diagonal_(diagonalLine(params.transitionFrames - 1)),
      diagonalBits_(diagonal_),
      lines_(warpedLines(params.transitionFrames - 1, params.largestSpanRatio)),
      lineBits_(lines_.begin(), lines_.end()),
      largestLean_(lines_.empty() ? 0 : lines_.back().lean()) {
  STRIDEGRAPH_CHECK(params.transitionFrames >= 2 && params.transitionFrames <= kMostFrames);
  STRIDEGRAPH_CHECK(params.neighbourFrames <= 1000);
  STRIDEGRAPH_CHECK(params.largestSpanRatio >= 1.0 && params.largestSpanRatio <= 2.0);
  leaning_.resize(lines_.empty() ? 0 : 4 * params.neighbourFrames + 4 * largestLean_ + 4);
  restart(0);
}

std::uint32_t ValleyFinder::limitMicrometres(double thresholdMetres) {
  return static_cast<std::uint32_t>(
      std::min(thresholdMetres * kMicrometresPerMetre, static_cast<double>(kLargestLimit)));
}

void ValleyFinder::restart(std::size_t columns) {
  const std::size_t crossed = params_.transitionFrames + largestLean_;
  const std::size_t compared = 2 * params_.neighbourFrames + largestLean_ + 2;
  columns_ = columns;
  oneClip_ = false;
  rows_ = 0;
  judged_ = 0;
  distances_.restart(params_.tellLargest ? crossed + compared + 1 : crossed + 1,
                     params_.transitionFrames + columns + kClump);
  sums_.restart(compared, columns + 1);
  diagonals_.restart(compared, ThresholdBits::wordsFor(columns));
  under_.restart(crossed + 1, columns, crossed);
  for (std::vector<Leaning>& leaning : leaning_) leaning.clear();
  regions_.clear();
}

void ValleyFinder::restartOfOneClip(std::size_t columns) {
  restart(columns);
  oneClip_ = true;
}

std::size_t ValleyFinder::reach() const {
  const std::size_t square = 2 * params_.neighbourFrames;
  return square > params_.transitionFrames ? square - params_.transitionFrames : 0;
}

void ValleyFinder::addRow(std::span<const std::uint32_t> micrometres, std::size_t firstColumn) {
  STRIDEGRAPH_CHECK(micrometres.size() == columns_);
  addSums(micrometres, firstColumn);
  under_.addRow(micrometres, firstColumn, limitMicrometres_);
  ++rows_;
  findLines();
  if (rows_ > judged_ + params_.neighbourFrames + largestLean_) judgeRow(judged_++);
}

void ValleyFinder::addSums(std::span<const std::uint32_t> micrometres, std::size_t firstColumn) {
  const std::size_t length = params_.transitionFrames;
  SumRow row;
  row.entering = micrometres.data();
  row.stored = distances_.push() + length;
  row.leaving = distances_.back(length);
  row.before = sums_.back(0);
  row.sums = sums_.push() + 1;
  row.begin = firstColumn;
  row.end = columns_;
  if (hasWideRegisters()) return sumWide(row);
  sumColumns(row);
}

void ValleyFinder::findLines() {
  const std::size_t lastRow = rows_ - 1;
  if (!lines_.empty()) {
    // Middles that no line ending above has reached take over the places of such as are judged.
    const std::size_t steps = params_.transitionFrames - 1;
    const std::size_t newest = 2 * lastRow + largestLean_;
    if (newest > steps) {
      leaningAt(newest - steps).clear();
      leaningAt(newest - steps - 1).clear();
    }
  }
  const std::size_t firstColumn = oneClip_ ? lastRow + params_.transitionFrames : 0;
  std::uint64_t* diagonals = diagonals_.push();
  for (std::size_t w = 0; w < ThresholdBits::wordsFor(columns_); ++w) {
    diagonals[w] = 0;
    const std::uint64_t allowed = bitsFrom(firstColumn, w);
    if ((under_.word(w) & allowed) == 0) continue;
    diagonals[w] = under_.lineEnds(diagonalBits_, w) & allowed;
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      const std::uint64_t lastColumns = under_.lineEnds(lineBits_[k], w) & allowed;
      if (lastColumns != 0) addLeaning(lines_[k], w, lastColumns);
    }
  }
}

void ValleyFinder::addLeaning(const WarpedLine& line, std::size_t word, std::uint64_t lastColumns) {
  const std::size_t length = params_.transitionFrames;
  const std::size_t row = rows_ - 1 - line.rowSpan;
  std::vector<Leaning>& leaning = leaningAt(2 * row + line.rowSpan);
  cells_.clear();
  for (const CellBack& cell : line.cells)
    cells_.push_back(distances_.back(cell.rows) + length - cell.columns);
  while (lastColumns != 0) {
    const std::size_t first = columnOf(word, lastColumns);
    const ClumpSums sums = sumClump(cells_, first);
    for (std::size_t k = 0; k < sums.size() && lastColumns != 0; k = columnOf(word, lastColumns) - first) {
      lastColumns &= lastColumns - 1;
      const std::size_t column = first + k - line.columnSpan;
      if (!oneClip_ || column >= row + length)
        leaning.push_back({&line, 2 * row + line.rowSpan, 2 * column + line.columnSpan, sums[k]});
    }
  }
}

bool ValleyFinder::isDiagonal(std::size_t row, std::size_t column) const {
  return (diagonals(row)[column / kWordBits] >> column % kWordBits & 1U) != 0;
}

bool ValleyFinder::isMuchBetter(const Leaning& leaning, std::uint32_t diagonalSum) const {
  return leaning.sum * params_.transitionFrames * kLeanPenaltyNumerator <
         std::uint64_t{diagonalSum} * leaning.cells() * kLeanPenaltyDenominator;
}

void ValleyFinder::judgeRow(std::size_t row) {
  if (row < rows_) judgeDiagonals(row);
  const std::size_t steps = params_.transitionFrames - 1;
  if (lines_.empty() || 2 * row < steps) return;
  judgeLeaning(2 * row - steps);
  judgeLeaning(2 * row - steps + 1);
}

void ValleyFinder::judgeDiagonals(std::size_t row) {
  const std::size_t steps = params_.transitionFrames - 1;
  for (std::size_t w = 0; w < ThresholdBits::wordsFor(columns_); ++w) {
    for (std::uint64_t ends = diagonals(row)[w]; ends != 0; ends &= ends - 1) {
      const std::size_t c = columnOf(w, ends);
      // Few are less than those right beside them.
      if (!isLeast(row, c, std::min<std::size_t>(1, params_.neighbourFrames)) ||
          !isLeast(row, c, params_.neighbourFrames) || isBeatenByLeaning(row, c))
        continue;
      regions_.push_back({row - steps, c - steps, steps, steps,
                          metresOf(sums(row)[c + 1], params_.transitionFrames),
                          largestAlong(diagonal_, row, c)});
    }
  }
}

bool ValleyFinder::isLeast(std::size_t row, std::size_t column, std::size_t reach) const {
  const std::size_t earliest = params_.transitionFrames - 1;
  const std::uint32_t own = sums(row)[column + 1];
  const std::size_t firstRow = std::max(earliest, row - std::min(row, reach));
  const std::size_t lastRow = std::min(rows_ - 1, row + reach);
  const std::size_t firstColumn = std::max(earliest, column - std::min(column, reach));
  const std::size_t lastColumn = std::min(columns_ - 1, column + reach);
  for (std::size_t r = firstRow; r <= lastRow; ++r) {
    const std::uint32_t* others = sums(r) + 1;
    for (std::size_t c = firstColumn; c <= lastColumn; ++c) {
      const bool earlier = r < row || (r == row && c < column);
      if (others[c] < own || (earlier && others[c] == own)) return false;
    }
  }
  return true;
}

bool ValleyFinder::isBeatenByLeaning(std::size_t row, std::size_t column) const {
  if (lines_.empty()) return false;
  const std::size_t reach2 = 2 * params_.neighbourFrames;
  const std::size_t middleRow2 = 2 * row + 1 - params_.transitionFrames;
  const std::size_t middleColumn2 = 2 * column + 1 - params_.transitionFrames;
  const std::uint32_t own = sums(row)[column + 1];
  for (std::size_t m = middleRow2 - std::min(middleRow2, reach2); m <= middleRow2 + reach2; ++m) {
    for (const Leaning& leaning : leaningAt(m)) {
      if (leaning.middleRow2 == m && apart(leaning.middleColumn2, middleColumn2) <= reach2 &&
          isMuchBetter(leaning, own))
        return true;
    }
  }
  return false;
}

void ValleyFinder::judgeLeaning(std::size_t middleRow2) {
  for (const Leaning& leaning : leaningAt(middleRow2)) {
    // Most are beaten by the diagonals right beside them.
    if (leaning.middleRow2 != middleRow2 ||
        isBeatenByDiagonal(leaning, std::min<std::size_t>(1, params_.neighbourFrames)) ||
        isBeatenByDiagonal(leaning, params_.neighbourFrames) || !isLeastLeaning(leaning))
      continue;
    const WarpedLine& line = *leaning.line;
    regions_.push_back(
        {leaning.row(), leaning.column(), line.rowSpan, line.columnSpan,
         metresOf(leaning.sum, leaning.cells()),
         largestAlong(line, leaning.row() + line.rowSpan, leaning.column() + line.columnSpan)});
  }
}

bool ValleyFinder::isBeatenByDiagonal(const Leaning& leaning, std::size_t reach) const {
  const std::size_t steps = params_.transitionFrames - 1;
  // Ends of the diagonals whose middles lie in the neighbourhood; the first of them a half cell inside.
  const std::size_t middleRow = (leaning.middleRow2 + steps + 1) / 2;
  const std::size_t middleColumn = (leaning.middleColumn2 + steps + 1) / 2;
  const std::size_t firstRow = std::max(steps, middleRow - std::min(middleRow, reach));
  const std::size_t lastRow = std::min(rows_ - 1, (leaning.middleRow2 + steps) / 2 + reach);
  const std::size_t firstColumn = std::max(steps, middleColumn - std::min(middleColumn, reach));
  const std::size_t lastColumn = std::min(columns_ - 1, (leaning.middleColumn2 + steps) / 2 + reach);
  for (std::size_t r = firstRow; r <= lastRow; ++r) {
    for (std::size_t c = firstColumn; c <= lastColumn; ++c) {
      if (isDiagonal(r, c) && !isMuchBetter(leaning, sums(r)[c + 1])) return true;
    }
  }
  return false;
}

bool ValleyFinder::isLeastLeaning(const Leaning& leaning) const {
  const std::size_t reach2 = 2 * params_.neighbourFrames;
  const std::size_t middle = leaning.middleRow2;
  for (std::size_t m = middle - std::min(middle, reach2); m <= middle + reach2; ++m) {
    for (const Leaning& other : leaningAt(m)) {
      if (other.middleRow2 == m && apart(other.middleColumn2, leaning.middleColumn2) <= reach2 &&
          other.precedes(leaning))
        return false;
    }
  }
  return true;
}

std::uint32_t ValleyFinder::largestAlong(const WarpedLine& line, std::size_t lastRow,
                                         std::size_t lastColumn) const {
  if (!params_.tellLargest) return 0;
  std::uint32_t largest = 0;
  for (const CellBack& cell : line.cells) {
    const std::uint32_t* row = distances_.back(rows_ - 1 - lastRow + cell.rows) + params_.transitionFrames;
    largest = std::max(largest, row[lastColumn - cell.columns]);
  }
  return largest;
}

std::vector<Region> ValleyFinder::finish() {
  // The shortest lines have their middles beyond those of the diagonals that end in the last row.
  while (judged_ < rows_ + largestLean_) judgeRow(judged_++);
  std::sort(regions_.begin(), regions_.end(), [](const Region& a, const Region& b) {
    return std::tie(a.row, a.column, a.rowSpan) < std::tie(b.row, b.column, b.rowSpan);
  });
  return std::move(regions_);
}

}  // namespace stridegraph
