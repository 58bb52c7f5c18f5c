#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace stridegraph {

struct ValleyParams {
  double thresholdMetres = 0.05;      ///< tau, > 0: no distance along a region is larger.
  std::size_t transitionFrames = 13;  ///< l >= 2: length of a region.
  /// The best diagonal is the least within this many frames on all sides, 0..1000 (6: as good for walking as
  /// 3, with a fifth fewer transitions).
  std::size_t neighbourFrames = 6;
};

/// The region of l frames along a diagonal where two clips are alike (fig. 5.3 c).
struct Region {
  std::size_t row = 0;     ///< First window in the one clip,
  std::size_t column = 0;  ///< and in the other.
  double meanDistanceMetres = 0.0;
};

/// Finds the interpolation regions of two clips (section 5.3.2) in the rows of their similarity matrix, which
/// are shown one after the other and not kept: of the diagonals that stay under tau, those whose mean
/// distance is least among their neighbours. Distances are whole micrometres, and of equal means the one with
/// the lower row, then the lower column wins; so no two regions lie within neighbourFrames of each other,
/// however flat the valley.
class ValleyFinder {
 public:
  ValleyFinder(const ValleyParams& params, std::size_t columns);
  /// For a clip with itself: only regions whose column is at least l after their row (nearer ones lead from a
  /// frame to itself). Rows need only be valid from reach() columns before the diagonal on.
  static ValleyFinder ofOneClip(const ValleyParams& params, std::size_t columns);

  std::size_t reach() const;
  /// The next row of the matrix, valid from `firstColumn` on.
  void addRow(std::span<const std::uint32_t> micrometres, std::size_t firstColumn);
  /// After the last row: the regions, by row, then column.
  std::vector<Region> finish();

 private:
  /// Mean distances times l of the diagonals that end in a row, and how long each has been under tau. Entry c
  /// + 1 is column c; entry 0 stays zero.
  struct Ends {
    std::vector<std::uint32_t> sums;
    std::vector<std::uint32_t> lengths;
  };

  void judgeRow(std::size_t row);
  bool isLeast(std::size_t row, std::size_t column) const;
  Ends& ends(std::size_t row) { return ends_[row % ends_.size()]; }
  const Ends& ends(std::size_t row) const { return ends_[row % ends_.size()]; }

  ValleyParams params_;
  std::uint32_t limitMicrometres_;
  std::size_t columns_;
  bool oneClip_ = false;
  std::size_t rows_ = 0;
  std::size_t judged_ = 0;
  std::vector<std::vector<std::uint32_t>> distances_;  ///< The last l rows and one more, each behind l zeros.
  std::vector<Ends> ends_;                             ///< The last 2 neighbourFrames + 1 rows and one more.
  std::vector<Region> regions_;
};

}  // namespace stridegraph
