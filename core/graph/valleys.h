#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "graph/recent_rows.h"
#include "graph/threshold_bits.h"
#include "graph/warped_lines.h"

namespace stridegraph {

struct ValleyParams {
  double thresholdMetres = 0.05;      ///< tau, > 0: no distance along a region is larger.
  std::size_t transitionFrames = 13;  ///< l >= 2: length of a region.
  /// The best region is the least within this many frames on all sides, 0..1000 (6: as good for walking as
  /// 3, with a fifth fewer transitions).
  std::size_t neighbourFrames = 6;
  /// How many times longer one side of a region may be than the other, 1 (never) to 2, the limit that Sakoe
  /// and Chiba 1978 found best for slopes of a time warp. 1.5 spans walks of which one is 2.2 times as fast:
  /// step rates go with the root of the speed (Inman 1981).
  double largestSpanRatio = 1.5;
  /// Also tell the largest distance along each region, for which more rows are kept.
  bool tellLargest = false;
};

/// A region where two clips are alike (fig. 5.3 c): l frames along a diagonal, or a line that leans, with a
/// mean length of l.
struct Region {
  std::size_t row = 0;         ///< First window in the one clip,
  std::size_t column = 0;      ///< and in the other.
  std::size_t rowSpan = 0;     ///< Steps in the one clip
  std::size_t columnSpan = 0;  ///< and in the other; l - 1 both, or so on average.
  double meanDistanceMetres = 0.0;
  /// Along it, where asked for: with every tau from this to the one given, the region is found as well.
  std::uint32_t largestMicrometres = 0;
};

/// Finds the interpolation regions of two clips (section 5.3.2) in the rows of their similarity matrix, which
/// are shown one after the other and not kept: of the diagonals that stay under tau, those whose mean
/// distance is least among their neighbours, and the leaning lines (warpedLines()) that do so where no
/// diagonal is nearly as good. Distances are whole micrometres; ties go to the line that leans less, then to
/// the lower row, then the lower column; so no two regions have their middles within neighbourFrames of each
/// other, however flat the valley.
class ValleyFinder {
 public:
  /// A leaning line must be this much better than a diagonal beside it: by a sixth of the diagonal's mean
  /// distance, so that the graph gains ways rather than twins.
  static constexpr std::uint64_t kLeanPenaltyNumerator = 6;
  static constexpr std::uint64_t kLeanPenaltyDenominator = 5;

  explicit ValleyFinder(const ValleyParams& params);
  /// The threshold in whole micrometres, as distances are compared with it.
  static std::uint32_t limitMicrometres(double thresholdMetres);

  /// Begins with the matrix of two clips, in the memory of the one before.
  void restart(std::size_t columns);
  /// The same for a clip with itself: only regions whose columns are at least l after their rows at both ends
  /// (nearer ones lead from a frame to itself). Rows need only be valid from reach() columns before the
  /// diagonal on.
  void restartOfOneClip(std::size_t columns);

  std::size_t reach() const;
  /// The next row of the matrix, valid from `firstColumn` on.
  void addRow(std::span<const std::uint32_t> micrometres, std::size_t firstColumn);
  /// Regions found so far.
  std::size_t regionCount() const { return regions_.size(); }
  /// After the last row: the regions, by row, then column, then spans.
  std::vector<Region> finish();

 private:
  /// A leaning line under tau, with the middle between its ends in half rows and columns.
  struct Leaning {
    const WarpedLine* line = nullptr;
    std::size_t middleRow2 = 0;
    std::size_t middleColumn2 = 0;
    std::uint64_t sum = 0;

    std::uint64_t cells() const { return line->cells.size(); }
    std::size_t row() const { return (middleRow2 - line->rowSpan) / 2; }
    std::size_t column() const { return (middleColumn2 - line->columnSpan) / 2; }
    bool precedes(const Leaning& other) const;
  };

  void addSums(std::span<const std::uint32_t> micrometres, std::size_t firstColumn);
  void findLines();
  void addLeaning(const WarpedLine& line, std::size_t word, std::uint64_t lastColumns);
  void judgeRow(std::size_t row);
  void judgeDiagonals(std::size_t row);
  void judgeLeaning(std::size_t middleRow2);
  bool isDiagonal(std::size_t row, std::size_t column) const;
  bool isLeast(std::size_t row, std::size_t column, std::size_t reach) const;
  bool isBeatenByLeaning(std::size_t row, std::size_t column) const;
  bool isBeatenByDiagonal(const Leaning& leaning, std::size_t reach) const;
  bool isLeastLeaning(const Leaning& leaning) const;
  bool isMuchBetter(const Leaning& leaning, std::uint32_t diagonalSum) const;
  std::uint32_t largestAlong(const WarpedLine& line, std::size_t lastRow, std::size_t lastColumn) const;
  /// Of the diagonals that end in a row: their distances, summed; entry c + 1 is column c, entry 0 stays
  /// zero.
  const std::uint32_t* sums(std::size_t row) const { return sums_.back(rows_ - 1 - row); }
  /// And whether they are under tau, a bit each.
  const std::uint64_t* diagonals(std::size_t row) const { return diagonals_.back(rows_ - 1 - row); }
  std::vector<Leaning>& leaningAt(std::size_t middleRow2) { return leaning_[middleRow2 % leaning_.size()]; }
  const std::vector<Leaning>& leaningAt(std::size_t middleRow2) const {
    return leaning_[middleRow2 % leaning_.size()];
  }

  ValleyParams params_;
  std::uint32_t limitMicrometres_;
  WarpedLine diagonal_;
  BitLine diagonalBits_;
  std::vector<WarpedLine> lines_;
  std::vector<BitLine> lineBits_;  ///< For each of lines_.
  std::size_t largestLean_;
  std::size_t columns_ = 0;
  bool oneClip_ = false;
  std::size_t rows_ = 0;
  std::size_t judged_ = 0;
  /// The last rows that lines cross, or that regions lie in which are yet to be judged, each behind l zeros.
  RecentRows<std::uint32_t> distances_;
  RecentRows<std::uint32_t> sums_;       ///< The last rows that are judged or compared.
  RecentRows<std::uint64_t> diagonals_;  ///< The same rows.
  ThresholdBits under_;
  /// By middleRow2 in turns; places that nothing has taken over yet hold lines of other middles.
  std::vector<std::vector<Leaning>> leaning_;
  std::vector<const std::uint32_t*> cells_;  ///< Scratch: where the rows of a line's cells begin.
  std::vector<Region> regions_;
};

}  // namespace stridegraph
