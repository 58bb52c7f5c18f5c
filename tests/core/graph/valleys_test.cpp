#include "graph/valleys.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "math/random.h"

namespace stridegraph {
namespace {

using Matrix = std::vector<std::vector<std::uint32_t>>;

Matrix filled(std::size_t rows, std::size_t columns, std::uint32_t micrometres) {
  return Matrix(rows, std::vector<std::uint32_t>(columns, micrometres));
}

std::vector<Region> regionsIn(ValleyFinder& finder, const Matrix& matrix) {
  for (const std::vector<std::uint32_t>& row : matrix) finder.addRow(row, 0);
  return finder.finish();
}

std::vector<Region> regionsOf(const ValleyParams& params, const Matrix& matrix) {
  ValleyFinder finder(params);
  finder.restart(matrix.front().size());
  return regionsIn(finder, matrix);
}

std::vector<Region> regionsOfOneClip(const ValleyParams& params, const Matrix& matrix) {
  ValleyFinder finder(params);
  finder.restartOfOneClip(matrix.front().size());
  return regionsIn(finder, matrix);
}

/// Straight from the definition, for comparison.
std::vector<Region> regionsByDefinition(const ValleyParams& params, const Matrix& matrix) {
  const std::size_t l = params.transitionFrames;
  const auto sumAt = [&](std::size_t r, std::size_t c) {
    std::uint64_t sum = 0;
    for (std::size_t k = 0; k < l; ++k) sum += matrix[r + k][c + k];
    return sum;
  };
  std::vector<Region> regions;
  for (std::size_t r = 0; r + l <= matrix.size(); ++r) {
    for (std::size_t c = 0; c + l <= matrix[0].size(); ++c) {
      bool good = true;
      for (std::size_t k = 0; k < l; ++k) good = good && matrix[r + k][c + k] <= params.thresholdMetres * 1e6;
      for (std::size_t i = 0; i + l <= matrix.size() && good; ++i) {
        for (std::size_t j = 0; j + l <= matrix[0].size() && good; ++j) {
          const auto apart = [](std::size_t a, std::size_t b) { return a > b ? a - b : b - a; };
          if (apart(i, r) > params.neighbourFrames || apart(j, c) > params.neighbourFrames) continue;
          const bool earlier = i < r || (i == r && j < c);
          good = sumAt(i, j) > sumAt(r, c) || (sumAt(i, j) == sumAt(r, c) && !earlier);
        }
      }
      if (good)
        regions.push_back(
            {r, c, l - 1, l - 1, static_cast<double>(sumAt(r, c)) / static_cast<double>(l) / 1e6});
    }
  }
  return regions;
}

TEST(ValleyFinder, findsTheOneDiagonalUnderTheThreshold) {
  Matrix matrix = filled(30, 40, 90'000);
  for (std::size_t k = 0; k < 5; ++k) matrix[10 + k][20 + k] = 20'000;
  const std::vector<Region> regions = regionsOf({.transitionFrames = 5, .neighbourFrames = 3}, matrix);
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0].row, 10U);
  EXPECT_EQ(regions[0].column, 20U);
  EXPECT_NEAR(regions[0].meanDistanceMetres, 0.02, 1e-12);
}

TEST(ValleyFinder, wantsEveryCellUnderTheThreshold) {
  Matrix matrix = filled(30, 40, 90'000);
  for (std::size_t k = 0; k < 5; ++k) matrix[10 + k][20 + k] = 10'000;
  matrix[12][22] = 50'001;
  EXPECT_TRUE(regionsOf({.transitionFrames = 5}, matrix).empty());
  matrix[12][22] = 50'000;
  EXPECT_EQ(regionsOf({.transitionFrames = 5}, matrix).size(), 1U);
}

TEST(ValleyFinder, givesAFlatValleyFewRegionsFarApart) {
  const std::vector<Region> regions =
      regionsOf({.transitionFrames = 5, .neighbourFrames = 3}, filled(60, 60, 1000));
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0].row, 0U);
  EXPECT_EQ(regions[0].column, 0U);
}

TEST(ValleyFinder, agreesWithTheDefinitionOnRandomMatrices) {
  Random random(11);
  for (int i = 0; i < 20; ++i) {
    Matrix matrix = filled(30 + random.below(10), 30 + random.below(10), 0);
    // Few different values, so that ties are common.
    for (auto& row : matrix) {
      for (std::uint32_t& cell : row) cell = static_cast<std::uint32_t>(random.below(8) * 8'000);
    }
    const ValleyParams params{
        .thresholdMetres = 0.05, .transitionFrames = 2 + random.below(4), .neighbourFrames = random.below(5)};
    const std::vector<Region> found = regionsOf(params, matrix);
    const std::vector<Region> expected = regionsByDefinition(params, matrix);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_EQ(found[k].row, expected[k].row);
      EXPECT_EQ(found[k].column, expected[k].column);
      EXPECT_NEAR(found[k].meanDistanceMetres, expected[k].meanDistanceMetres, 1e-12);
    }
  }
}

/// A line of either kind, under the threshold from end to end, straight from the definition.
struct Line {
  WarpedLine shape;
  std::size_t row = 0;
  std::size_t column = 0;
  std::uint64_t sum = 0;

  std::uint64_t cells() const { return shape.cells.size(); }
  bool isDiagonal() const { return shape.rowSpan == shape.columnSpan; }
  std::size_t middleRow2() const { return 2 * row + shape.rowSpan; }
  std::size_t middleColumn2() const { return 2 * column + shape.columnSpan; }
  bool isBetterThan(const Line& other) const {
    const std::uint64_t own = sum * other.cells() * (isDiagonal() ? 5 : 6);
    const std::uint64_t others = other.sum * cells() * (other.isDiagonal() ? 5 : 6);
    if (isDiagonal() != other.isDiagonal()) return isDiagonal() ? own <= others : own < others;
    if (own != others) return own < others;
    const auto key = [](const Line& l) {
      return std::tuple(l.shape.lean(), l.middleRow2(), l.middleColumn2(), l.shape.rowSpan);
    };
    return key(*this) < key(other);
  }
};

std::vector<Line> linesUnderThreshold(const ValleyParams& params, const Matrix& matrix) {
  const std::size_t steps = params.transitionFrames - 1;
  std::vector<WarpedLine> shapes = warpedLines(steps, params.largestSpanRatio);
  WarpedLine& diagonal = shapes.emplace_back(WarpedLine{steps, steps, {}});
  for (std::size_t k = 0; k <= steps; ++k) diagonal.cells.push_back({k, k});
  std::vector<Line> lines;
  for (const WarpedLine& shape : shapes) {
    for (std::size_t r = 0; r + shape.rowSpan < matrix.size(); ++r) {
      for (std::size_t c = 0; c + shape.columnSpan < matrix[0].size(); ++c) {
        Line line{shape, r, c, 0};
        bool isUnder = true;
        for (const CellBack& cell : shape.cells) {
          const std::uint32_t here =
              matrix[r + shape.rowSpan - cell.rows][c + shape.columnSpan - cell.columns];
          isUnder = isUnder && here <= params.thresholdMetres * 1e6;
          line.sum += here;
        }
        if (isUnder) lines.push_back(line);
      }
    }
  }
  return lines;
}

TEST(ValleyFinder, agreesWithTheDefinitionOnLeaningValleys) {
  Random random(13);
  std::size_t leaning = 0;
  for (int i = 0; i < 30; ++i) {
    const std::size_t rows = 30 + random.below(30);
    Matrix matrix = filled(rows, 60, 0);
    const double slope = 0.6 + 0.1 * static_cast<double>(random.below(10));
    for (std::size_t r = 0; r < rows; ++r) {
      for (std::size_t c = 0; c < 60; ++c) {
        const double off = static_cast<double>(c) - 10.0 - slope * static_cast<double>(r);
        matrix[r][c] = static_cast<std::uint32_t>(std::abs(off) * 12'000.0) +
                       static_cast<std::uint32_t>(random.below(5)) * 3'000;
      }
    }
    const ValleyParams params{
        .transitionFrames = 8 + random.below(6), .neighbourFrames = random.below(7), .largestSpanRatio = 2.0};
    std::vector<std::tuple<std::size_t, std::size_t, std::size_t>> expected;
    const std::vector<Line> lines = linesUnderThreshold(params, matrix);
    for (const Line& line : lines) {
      const auto apart = [](std::size_t a, std::size_t b) { return a > b ? a - b : b - a; };
      const bool isBeaten = std::any_of(lines.begin(), lines.end(), [&](const Line& other) {
        return apart(line.middleRow2(), other.middleRow2()) <= 2 * params.neighbourFrames &&
               apart(line.middleColumn2(), other.middleColumn2()) <= 2 * params.neighbourFrames &&
               other.isBetterThan(line);
      });
      if (!isBeaten && !line.isDiagonal()) expected.emplace_back(line.row, line.column, line.shape.rowSpan);
    }
    std::sort(expected.begin(), expected.end());
    std::vector<std::tuple<std::size_t, std::size_t, std::size_t>> found;
    for (const Region& region : regionsOf(params, matrix)) {
      if (region.rowSpan != region.columnSpan) found.emplace_back(region.row, region.column, region.rowSpan);
    }
    ASSERT_EQ(found, expected);
    leaning += found.size();
  }
  EXPECT_GT(leaning, 30U);
}

TEST(ValleyFinder, leansOnlyWhereNoDiagonalIsNearlyAsGood) {
  // A valley of slope 14 : 10, steep enough that diagonals leave it.
  Matrix matrix = filled(40, 40, 90'000);
  for (std::size_t k = 0; k <= 14; ++k) matrix[10 + (2 * 10 * k + 14) / 28][12 + k] = 20'000;
  ASSERT_EQ(regionsOf({.largestSpanRatio = 1.0}, matrix).size(), 0U);
  std::vector<Region> regions = regionsOf({}, matrix);
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0].row, 10U);
  EXPECT_EQ(regions[0].column, 12U);
  EXPECT_EQ(regions[0].rowSpan, 10U);
  EXPECT_EQ(regions[0].columnSpan, 14U);
  EXPECT_NEAR(regions[0].meanDistanceMetres, 0.02, 1e-12);
  for (std::size_t k = 0; k < 13; ++k) matrix[9 + k][13 + k] = 23'000;
  regions = regionsOf({}, matrix);
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0].rowSpan, 12U);
  for (std::size_t k = 0; k < 13; ++k) {
    if (matrix[9 + k][13 + k] == 23'000) matrix[9 + k][13 + k] = 40'000;
  }
  regions = regionsOf({}, matrix);
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0].rowSpan, 10U);
}

TEST(ValleyFinder, forgetsTheMatrixBefore) {
  Random random(13);
  const ValleyParams params{.transitionFrames = 5, .neighbourFrames = 3};
  ValleyFinder finder(params);
  for (int i = 0; i < 6; ++i) {
    Matrix matrix = filled(30 + random.below(10), 30 + random.below(90), 0);
    for (auto& row : matrix) {
      for (std::uint32_t& cell : row) cell = static_cast<std::uint32_t>(random.below(8) * 8'000);
    }
    const bool oneClip = i % 2 == 0;
    if (oneClip)
      finder.restartOfOneClip(matrix[0].size());
    else
      finder.restart(matrix[0].size());
    const std::vector<Region> found = regionsIn(finder, matrix);
    const std::vector<Region> expected =
        oneClip ? regionsOfOneClip(params, matrix) : regionsOf(params, matrix);
    ASSERT_FALSE(expected.empty());
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_EQ(found[k].row, expected[k].row);
      EXPECT_EQ(found[k].column, expected[k].column);
      EXPECT_EQ(found[k].rowSpan, expected[k].rowSpan);
      EXPECT_EQ(found[k].meanDistanceMetres, expected[k].meanDistanceMetres);
    }
  }
}

TEST(ValleyFinder, ofOneClipLeavesOutWhatLiesNearTheDiagonal) {
  Matrix matrix = filled(40, 40, 90'000);
  for (std::size_t k = 0; k + 20 < 40; ++k) matrix[k][k + 20] = 20'000 + 100 * static_cast<std::uint32_t>(k);
  for (std::size_t k = 0; k + 4 < 40; ++k) matrix[k][k + 4] = 10'000;
  const ValleyParams params{.transitionFrames = 5, .neighbourFrames = 3};
  const std::vector<Region> regions = regionsOfOneClip(params, matrix);
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0].row, 0U);
  EXPECT_EQ(regions[0].column, 20U);
}

TEST(ValleyFinder, ofOneClipNeedsNothingBeyondItsReach) {
  Random random(12);
  const ValleyParams params{.transitionFrames = 4, .neighbourFrames = 6};
  Matrix matrix = filled(60, 60, 0);
  for (auto& row : matrix) {
    for (std::uint32_t& cell : row) cell = static_cast<std::uint32_t>(random.below(60'000));
  }
  const std::vector<Region> whole = regionsOfOneClip(params, matrix);
  ValleyFinder finder(params);
  finder.restartOfOneClip(60);
  const std::size_t reach = finder.reach();
  for (std::size_t r = 0; r < matrix.size(); ++r) {
    const std::size_t first = r > reach ? r - reach : 0;
    for (std::size_t c = 0; c < first; ++c) matrix[r][c] = 4'000'000'000U;
    finder.addRow(matrix[r], first);
  }
  const std::vector<Region> part = finder.finish();
  ASSERT_FALSE(whole.empty());
  ASSERT_EQ(part.size(), whole.size());
  for (std::size_t k = 0; k < part.size(); ++k) EXPECT_EQ(part[k].column, whole[k].column);
}

/// The largest cell of a region's line.
std::uint32_t largestOf(const Region& region, const Matrix& matrix) {
  std::uint32_t largest = 0;
  const std::size_t steps = std::max(region.rowSpan, region.columnSpan);
  for (std::size_t k = 0; k <= steps; ++k) {
    const std::size_t row = region.row + (2 * k * region.rowSpan + steps) / (2 * steps);
    const std::size_t column = region.column + (2 * k * region.columnSpan + steps) / (2 * steps);
    largest = std::max(largest, matrix[row][column]);
  }
  return largest;
}

TEST(ValleyFinder, tellsTheLargestDistanceFromWhichOnARegionIsFound) {
  Random random(21);
  std::size_t compared = 0;
  for (int k = 0; k < 12; ++k) {
    ValleyParams params{.thresholdMetres = 0.06,
                        .transitionFrames = 4 + random.below(9),
                        .neighbourFrames = random.below(7),
                        .largestSpanRatio = random.below(2) == 0 ? 1.0 : 1.5,
                        .tellLargest = true};
    Matrix matrix = filled(50, 47, 0);
    for (std::size_t r = 0; r < 50; ++r) {
      // Smooth along diagonals, so that lines of every length lie under the threshold.
      for (std::size_t c = 0; c < 47; ++c)
        matrix[r][c] = static_cast<std::uint32_t>(
            40'000.0 + 25'000.0 * std::sin(0.3 * static_cast<double>(r) - 0.27 * static_cast<double>(c)) +
            random.uniform(0.0, 8'000.0));
    }
    const std::vector<Region> regions = regionsOf(params, matrix);
    for (const Region& region : regions) {
      EXPECT_EQ(region.largestMicrometres, largestOf(region, matrix));
      ValleyParams smaller = params;
      smaller.thresholdMetres = (region.largestMicrometres + 0.5) * 1e-6;
      const std::vector<Region> fewer = regionsOf(smaller, matrix);
      const bool found = std::any_of(fewer.begin(), fewer.end(), [&](const Region& one) {
        return std::tie(one.row, one.column, one.rowSpan) ==
               std::tie(region.row, region.column, region.rowSpan);
      });
      EXPECT_TRUE(found);
      ++compared;
    }
  }
  EXPECT_GT(compared, 100U);
}

}  // namespace
}  // namespace stridegraph
