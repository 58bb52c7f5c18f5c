#include "graph/row_products.h"

#include <gtest/gtest.h>

#include "math/random.h"

namespace stridegraph {
namespace {

TEST(RowProducts, areSumsInTheOrderOfTheTermsToTheLastBit) {
  constexpr std::size_t kStride = 120;
  Random random(51);
  const auto number = [&] { return static_cast<float>(random.uniform(-1.0, 1.0)); };
  for (int i = 0; i < 20; ++i) {
    const std::size_t terms = 1 + random.below(50);
    std::vector<float> packed(terms * kProductRows);
    std::vector<float> columns(terms * kStride);
    for (float& factor : packed) factor = number();
    for (float& column : columns) column = number();
    const std::size_t begin = random.below(20);
    const std::size_t end = begin + 1 + random.below(kStride - begin - kProductColumns);
    std::vector<float> products(kProductRows * kStride, 0.0F);
    std::array<float*, kProductRows> rows;
    for (std::size_t r = 0; r < kProductRows; ++r) rows[r] = products.data() + r * kStride;
    multiplyRows(packed.data(), {columns.data(), kStride, terms, begin, end}, rows);
    for (std::size_t r = 0; r < kProductRows; ++r) {
      for (std::size_t c = begin; c < end; ++c) {
        float sum = 0.0F;
        for (std::size_t t = 0; t < terms; ++t)
          sum += packed[t * kProductRows + r] * columns[t * kStride + c];
        ASSERT_EQ(rows[r][c], sum);
      }
    }
  }
}

}  // namespace
}  // namespace stridegraph
