#pragma once

#include <cstddef>
#include <vector>

#include "base/result.h"
#include "motion/bvh_scanner.h"

namespace stridegraph {

/// What the head of a BVH says of its rows.
struct BvhRowShape {
  std::size_t columns = 1;   ///< Numbers in a row, at least 1.
  std::size_t joints = 1;    ///< Joints and end sites: a rotation is kept for each in every frame.
  std::size_t declared = 1;  ///< Frames, as declared; at least 1.
};

/// The numbers of whole rows, row by row.
struct BvhRows {
  std::vector<double> values;
  Warnings warnings;
};

/// Reads rows of numbers to the end of the text. A row ends where a line does; it may be wrapped over several
/// lines, and a line may hold several whole rows. A last row that is cut, and another number of rows than was
/// declared, are told in a warning (WarningTopic::kRows) and the whole rows are used; so is text behind the
/// last declared row. Fails with kBvhSyntax where a row has too few or too many numbers, naming its line,
/// also where rows of a wrong length add up to whole ones: then there are as many lines as declared frames.
/// Fails with kBvhValue beyond the limits of motion/bvh_limits.h.
Result<BvhRows> parseBvhRows(BvhScanner& scanner, const BvhRowShape& shape);

}  // namespace stridegraph
