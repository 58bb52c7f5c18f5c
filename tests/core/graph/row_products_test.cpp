#include "graph/row_products.h"

#include <gtest/gtest.h>

#include <vector>

#include "math/random.h"

namespace stridegraph {
namespace {

constexpr std::size_t kPanels = 15;
constexpr std::size_t kStride = (kPanels - 1) * kPanelColumns;  ///< The last panel is only for heights.
constexpr float kUntouched = 7.0F;

/// A matrix of panels with `points` points of `terms` terms in each column.
struct Columns {
  std::size_t terms;
  std::size_t points;
  std::vector<PanelTerm> panels{kPanels * terms * points, PanelTerm{}};

  float at(std::size_t column, std::size_t point, std::size_t term) const {
    return panels[(column / kPanelColumns * points + point) * terms + term].columns[column % kPanelColumns];
  }
};

Columns randomColumns(std::size_t terms, std::size_t points, Random& random) {
  Columns columns{terms, points};
  for (PanelTerm& term : columns.panels) {
    for (float& number : term.columns) number = static_cast<float>(random.uniform(-1.0, 1.0));
  }
  return columns;
}

struct Sums {
  float along = 0.0F;
  float across = 0.0F;
  float height = 0.0F;
};

Sums sumsOf(const Columns& rows, std::size_t row, const Columns& columns, std::size_t column) {
  Sums sums;
  for (std::size_t p = 0; p < rows.points; ++p) {
    sums.along += rows.at(row, p, 0) * columns.at(column, p, 0);
    sums.along += rows.at(row, p, 1) * columns.at(column, p, 1);
    sums.across += rows.at(row, p, 0) * columns.at(column, p, 1);
    sums.across -= rows.at(row, p, 1) * columns.at(column, p, 0);
    if (rows.terms == 3) sums.height += rows.at(row, p, 2) * columns.at(column, p, 2);
  }
  return sums;
}

TEST(RowProducts, areSumsInTheOrderOfThePointsToTheLastBit) {
  Random random(51);
  for (int i = 0; i < 40; ++i) {
    const auto terms = i % 2 == 0 ? PointTerms::kFloor : PointTerms::kSpace;
    const std::size_t points = 1 + random.below(25);
    const Columns rows = randomColumns(static_cast<std::size_t>(terms), points, random);
    const Columns columns = randomColumns(static_cast<std::size_t>(terms), points, random);
    const std::size_t row = kProductRows * random.below(kStride / kProductRows);
    const std::size_t begin = random.below(40);
    const std::size_t end = begin + 1 + random.below(kStride - begin);
    std::vector<float> along(kProductRows * kStride + kPanelColumns, 0.0F);
    std::vector<float> across = along;
    std::vector<float> height(along.size(), kUntouched);
    multiplyRows(rows.panels.data(), row, terms, {columns.panels.data(), points, begin, end},
                 {along.data(), across.data(), height.data(), kStride});
    for (std::size_t r = 0; r < kProductRows; ++r) {
      for (std::size_t c = begin; c < end; ++c) {
        const Sums sums = sumsOf(rows, row + r, columns, c);
        ASSERT_EQ(along[r * kStride + c], sums.along);
        ASSERT_EQ(across[r * kStride + c], sums.across);
        ASSERT_EQ(height[r * kStride + c], terms == PointTerms::kSpace ? sums.height : kUntouched);
      }
    }
  }
}

}  // namespace
}  // namespace stridegraph
