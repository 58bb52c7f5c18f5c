#include "graph/valleys.h"

#include <algorithm>

#include "base/check.h"
#include "graph/similarity.h"

namespace stridegraph {

ValleyFinder::ValleyFinder(const ValleyParams& params, std::size_t columns)
    : params_(params),
      limitMicrometres_(static_cast<std::uint32_t>(
          std::min(params.thresholdMetres * kMicrometresPerMetre, static_cast<double>(kFarMicrometres - 1)))),
      columns_(columns),
      distances_(params.transitionFrames + 1,
                 std::vector<std::uint32_t>(params.transitionFrames + columns, 0)),
      ends_(2 * params.neighbourFrames + 2,
            {std::vector<std::uint32_t>(columns + 1, 0), std::vector<std::uint32_t>(columns + 1, 0)}) {
  // A sum of l distances, each kFarMicrometres at most, has to fit 32 bits.
  STRIDEGRAPH_CHECK(params.transitionFrames >= 2 && params.transitionFrames <= 400);
  STRIDEGRAPH_CHECK(params.neighbourFrames <= 1000);
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
  const std::uint32_t* leaving = distances_[(rows_ + 1) % distances_.size()].data();
  const std::uint32_t* sumsBefore = before.sums.data();
  const std::uint32_t* lengthsBefore = before.lengths.data();
  std::uint32_t* sums = now.sums.data() + 1;
  std::uint32_t* lengths = now.lengths.data() + 1;
  const std::uint32_t limit = limitMicrometres_;
  for (std::size_t c = firstColumn; c < columns_; ++c) sums[c] = sumsBefore[c] + entering[c] - leaving[c];
  for (std::size_t c = firstColumn; c < columns_; ++c)
    lengths[c] = entering[c] <= limit ? lengthsBefore[c] + 1 : 0;
  ++rows_;
  if (rows_ > judged_ + params_.neighbourFrames) judgeRow(judged_++);
}

void ValleyFinder::judgeRow(std::size_t row) {
  const std::size_t length = params_.transitionFrames;
  const std::size_t firstColumn = oneClip_ ? row + length : length - 1;
  const std::uint32_t* lengths = ends(row).lengths.data() + 1;
  for (std::size_t c = firstColumn; c < columns_; ++c) {
    if (lengths[c] < length || !isLeast(row, c)) continue;
    const double mean =
        static_cast<double>(ends(row).sums[c + 1]) / static_cast<double>(length) / kMicrometresPerMetre;
    regions_.push_back({row + 1 - length, c + 1 - length, mean});
  }
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

std::vector<Region> ValleyFinder::finish() {
  while (judged_ < rows_) judgeRow(judged_++);
  return std::move(regions_);
}

}  // namespace stridegraph
