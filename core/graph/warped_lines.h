#pragma once

#include <cstddef>
#include <vector>

namespace stridegraph {

/// A cell of a line, counted back from the line's last one.
struct CellBack {
  std::size_t rows = 0;
  std::size_t columns = 0;
};

/// A straight line across a similarity matrix, rowSpan rows down and columnSpan columns on: it aligns two
/// pieces of motion of unequal length by a uniform time warp (section 3.2.4.2, delta_k of eq. 5.7).
struct WarpedLine {
  std::size_t rowSpan = 0;
  std::size_t columnSpan = 0;
  /// A cell for each step of the longer span, both ends included, at the nearest column or row of the other.
  /// Ends and middle come first: they tell soonest that a line will not do.
  std::vector<CellBack> cells;

  /// |columnSpan - rowSpan| / 2: how far it leans away from the diagonal.
  std::size_t lean() const;
};

/// The diagonal: `steps` rows down and as many columns on.
WarpedLine diagonalLine(std::size_t steps);

/// The lines whose spans differ, but have `steps` as their mean and are at most `largestRatio` (>= 1) apart,
/// by lean, the one with the longer columnSpan first. None for a ratio of 1.
std::vector<WarpedLine> warpedLines(std::size_t steps, double largestRatio);

}  // namespace stridegraph
