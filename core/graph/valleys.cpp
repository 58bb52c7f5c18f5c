#include "graph/valleys.h"

#include <algorithm>
#include <tuple>

#include "base/check.h"
#include "graph/similarity.h"

namespace stridegraph {
namespace {

std::size_t apart(std::size_t a, std::size_t b) {
  return a > b ? a - b : b - a;
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

ValleyFinder::ValleyFinder(const ValleyParams& params, std::size_t columns)
    : params_(params),
      limitMicrometres_(static_cast<std::uint32_t>(
          std::min(params.thresholdMetres * kMicrometresPerMetre, static_cast<double>(kFarMicrometres - 1)))),
      columns_(columns),
      lines_(warpedLines(params.transitionFrames - 1, params.largestSpanRatio)),
      largestLean_(lines_.empty() ? 0 : lines_.back().lean()),
      distances_(params.transitionFrames + largestLean_ + 1,
                 std::vector<std::uint32_t>(params.transitionFrames + columns, 0)),
      ends_(2 * params.neighbourFrames + largestLean_ + 2,
            {std::vector<std::uint32_t>(columns + 1, 0), std::vector<std::uint32_t>(columns + 1, 0)}),
      under_(distances_.size(), columns, params.transitionFrames + largestLean_),
      leaning_(lines_.empty() ? 0 : 4 * params.neighbourFrames + 4 * largestLean_ + 4) {
  // A sum of l distances, each kFarMicrometres at most, has to fit 32 bits.
  STRIDEGRAPH_CHECK(params.transitionFrames >= 2 && params.transitionFrames <= 400);
  STRIDEGRAPH_CHECK(params.neighbourFrames <= 1000);
  STRIDEGRAPH_CHECK(params.largestSpanRatio >= 1.0 && params.largestSpanRatio <= 2.0);
}

ValleyFinder ValleyFinder::ofOneClip(const ValleyParams& params, std::size_t columns) {
  ValleyFinder finder(params, columns);
  finder.oneClip_ = true;
  return finder;
}

std::size_t ValleyFinder::reach() const {
  const std::size_t square = 2 * params_.neighbourFrames;
  return square > params_.transitionFrames ? square - params_.transitionFrames : 0;
}

void ValleyFinder::addRow(std::span<const std::uint32_t> micrometres, std::size_t firstColumn) {
  STRIDEGRAPH_CHECK(micrometres.size() == columns_);
  const std::size_t length = params_.transitionFrames;
  std::vector<std::uint32_t>& stored = distances_[rows_ % distances_.size()];
  std::copy(micrometres.begin(), micrometres.end(), stored.begin() + static_cast<std::ptrdiff_t>(length));
  // Sums run along diagonals. Borders and rows before the first hold zeros, so that no cell is special;
  // unsigned, so that cells left of what is valid may hold anything.
  Ends& now = ends(rows_);
  const Ends& before = ends(rows_ + ends_.size() - 1);
  const std::uint32_t* entering = micrometres.data();
  const std::uint32_t* leaving = distances(rows_ + distances_.size() - length).data();
  const std::uint32_t* sumsBefore = before.sums.data();
  const std::uint32_t* lengthsBefore = before.lengths.data();
  std::uint32_t* sums = now.sums.data() + 1;
  std::uint32_t* lengths = now.lengths.data() + 1;
  const std::uint32_t limit = limitMicrometres_;
  for (std::size_t c = firstColumn; c < columns_; ++c) sums[c] = sumsBefore[c] + entering[c] - leaving[c];
  for (std::size_t c = firstColumn; c < columns_; ++c)
    lengths[c] = entering[c] <= limit ? lengthsBefore[c] + 1 : 0;
  if (!lines_.empty()) under_.addRow(micrometres, firstColumn, limit);
  ++rows_;
  findLeaning();
  if (rows_ > judged_ + params_.neighbourFrames + largestLean_) judgeRow(judged_++);
}

void ValleyFinder::findLeaning() {
  if (lines_.empty()) return;
  const std::size_t lastRow = rows_ - 1;
  // Middles that no line ending above has reached take over the places of such as are judged.
  const std::size_t steps = params_.transitionFrames - 1;
  const std::size_t newest = 2 * lastRow + largestLean_;
  if (newest > steps) {
    leaningAt(newest - steps).clear();
    leaningAt(newest - steps - 1).clear();
  }
  for (const WarpedLine& line : lines_) {
    found_.clear();
    under_.findLines(line, found_);
    for (const std::size_t lastColumn : found_) {
      if (lastColumn < line.columnSpan) continue;
      const std::size_t row = lastRow - line.rowSpan;
      const std::size_t column = lastColumn - line.columnSpan;
      const std::size_t length = params_.transitionFrames;
      if (oneClip_ && (column < row + length || lastColumn < lastRow + length)) continue;
      Leaning leaning{&line, 2 * row + line.rowSpan, 2 * column + line.columnSpan, 0};
      for (const CellBack& cell : line.cells)
        leaning.sum += distances(lastRow - cell.rows)[length + lastColumn - cell.columns];
      leaningAt(leaning.middleRow2).push_back(leaning);
    }
  }
}

bool ValleyFinder::isDiagonal(std::size_t row, std::size_t column) const {
  const std::size_t length = params_.transitionFrames;
  return ends(row).lengths[column + 1] >= length && (!oneClip_ || column >= row + length);
}

bool ValleyFinder::isMuchBetter(const Leaning& leaning, std::uint32_t diagonalSum) const {
  return leaning.sum * params_.transitionFrames * kLeanPenaltyNumerator <
         std::uint64_t{diagonalSum} * leaning.cells() * kLeanPenaltyDenominator;
}

void ValleyFinder::judgeRow(std::size_t row) {
  const std::size_t steps = params_.transitionFrames - 1;
  const std::size_t firstColumn = oneClip_ ? row + params_.transitionFrames : steps;
  for (std::size_t c = firstColumn; c < columns_ && row < rows_; ++c) {
    if (!isDiagonal(row, c) || !isLeast(row, c) || isBeatenByLeaning(row, c)) continue;
    regions_.push_back(
        {row - steps, c - steps, steps, steps, metresOf(ends(row).sums[c + 1], params_.transitionFrames)});
  }
  if (lines_.empty() || 2 * row < steps) return;
  judgeLeaning(2 * row - steps);
  judgeLeaning(2 * row - steps + 1);
}

bool ValleyFinder::isLeast(std::size_t row, std::size_t column) const {
  const std::size_t earliest = params_.transitionFrames - 1;
  const std::size_t reach = params_.neighbourFrames;
  const std::uint32_t own = ends(row).sums[column + 1];
  const std::size_t firstRow = std::max(earliest, row - std::min(row, reach));
  const std::size_t lastRow = std::min(rows_ - 1, row + reach);
  const std::size_t firstColumn = std::max(earliest, column - std::min(column, reach));
  const std::size_t lastColumn = std::min(columns_ - 1, column + reach);
  for (std::size_t r = firstRow; r <= lastRow; ++r) {
    const std::uint32_t* sums = ends(r).sums.data() + 1;
    for (std::size_t c = firstColumn; c <= lastColumn; ++c) {
      const bool earlier = r < row || (r == row && c < column);
      if (sums[c] < own || (earlier && sums[c] == own)) return false;
    }
  }
  return true;
}

bool ValleyFinder::isBeatenByLeaning(std::size_t row, std::size_t column) const {
  if (lines_.empty()) return false;
  const std::size_t reach2 = 2 * params_.neighbourFrames;
  const std::size_t middleRow2 = 2 * row + 1 - params_.transitionFrames;
  const std::size_t middleColumn2 = 2 * column + 1 - params_.transitionFrames;
  const std::uint32_t own = ends(row).sums[column + 1];
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
    if (leaning.middleRow2 != middleRow2 || isBeatenByDiagonal(leaning) || !isLeastLeaning(leaning)) continue;
    regions_.push_back({leaning.row(), leaning.column(), leaning.line->rowSpan, leaning.line->columnSpan,
                        metresOf(leaning.sum, leaning.cells())});
  }
}

bool ValleyFinder::isBeatenByDiagonal(const Leaning& leaning) const {
  const std::size_t reach = params_.neighbourFrames;
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
      if (isDiagonal(r, c) && !isMuchBetter(leaning, ends(r).sums[c + 1])) return true;
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

std::vector<Region> ValleyFinder::finish() {
  // The shortest lines have their middles beyond those of the diagonals that end in the last row.
  while (judged_ < rows_ + largestLean_) judgeRow(judged_++);
  std::sort(regions_.begin(), regions_.end(), [](const Region& a, const Region& b) {
    return std::tie(a.row, a.column, a.rowSpan) < std::tie(b.row, b.column, b.rowSpan);
  });
  return std::move(regions_);
}

}  // namespace stridegraph
