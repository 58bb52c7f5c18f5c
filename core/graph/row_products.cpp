#include "graph/row_products.h"

#include <cstring>

namespace stridegraph {
namespace {

// Four floats in a register of x86-64 or WebAssembly alike; GCC and Clang lower it to plain code elsewhere.
using Lanes = float __attribute__((vector_size(16)));
constexpr std::size_t kLanes = sizeof(Lanes) / sizeof(float);
static_assert(kProductColumns == 2 * kLanes);

Lanes load(const float* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof(lanes));
  return lanes;
}

Lanes spread(float value) {
  return Lanes{value, value, value, value};
}

}  // namespace

void multiplyRows(const float* packed, const ProductColumns& columns,
                  const std::array<float*, kProductRows>& products) {
  for (std::size_t column = columns.begin; column < columns.end; column += kProductColumns) {
    Lanes left[kProductRows] = {};
    Lanes right[kProductRows] = {};
    const float* term = columns.first + column;
    const float* factors = packed;
    for (std::size_t t = 0; t < columns.terms; ++t, term += columns.stride, factors += kProductRows) {
      const Lanes a = load(term);
      const Lanes b = load(term + kLanes);
      for (std::size_t r = 0; r < kProductRows; ++r) {
        const Lanes factor = spread(factors[r]);
        left[r] += factor * a;
        right[r] += factor * b;
      }
    }
    for (std::size_t r = 0; r < kProductRows; ++r) {
      std::memcpy(products[r] + column, &left[r], sizeof(Lanes));
      std::memcpy(products[r] + column + kLanes, &right[r], sizeof(Lanes));
    }
  }
}

}  // namespace stridegraph
