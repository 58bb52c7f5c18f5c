#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace stridegraph {

inline constexpr std::size_t kProductRows = 4;

/// Columns come in blocks of at most this many.
inline constexpr std::size_t kProductColumns = 16;

/// Columns to multiply: `terms` rows of floats, `stride` apart; begin..end of each, begin and the row starts
/// anywhere. Up to kProductColumns - 1 columns after end are read and written, too.
struct ProductColumns {
  const float* first = nullptr;
  std::size_t stride = 0;
  std::size_t terms = 0;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// products[r][c] = sum over terms of packed[term * kProductRows + r] * column[term][c], in the order of the
/// terms whatever the width of the machine's registers.
void multiplyRows(const float* packed, const ProductColumns& columns,
                  const std::array<float*, kProductRows>& products);

}  // namespace stridegraph
