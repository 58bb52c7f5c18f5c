#include "graph/row_products.h"

#include <cstring>

#include "base/wide.h"

namespace stridegraph {
namespace {

// Four floats in a register of x86-64 or WebAssembly alike; GCC and Clang lower it to plain code elsewhere.
using Lanes = float __attribute__((vector_size(16)));
using WideLanes = float __attribute__((vector_size(32)));

/// Two registers of each row at a time: as many sums as keep the adders busy without spilling.
template <typename Register>
STRIDEGRAPH_INLINE void multiplyWith(const float* packed, const ProductColumns& columns,
                                     const std::array<float*, kProductRows>& products) {
  constexpr std::size_t kLanes = sizeof(Register) / sizeof(float);
  static_assert(2 * kLanes <= kProductColumns);
  for (std::size_t column = columns.begin; column < columns.end; column += 2 * kLanes) {
    Register left[kProductRows] = {};
    Register right[kProductRows] = {};
    const float* term = columns.first + column;
    const float* factors = packed;
    for (std::size_t t = 0; t < columns.terms; ++t, term += columns.stride, factors += kProductRows) {
      Register a;
      Register b;
      std::memcpy(&a, term, sizeof(a));
      std::memcpy(&b, term + kLanes, sizeof(b));
      for (std::size_t r = 0; r < kProductRows; ++r) {
        left[r] += factors[r] * a;
        right[r] += factors[r] * b;
      }
    }
    for (std::size_t r = 0; r < kProductRows; ++r) {
      std::memcpy(products[r] + column, &left[r], sizeof(Register));
      std::memcpy(products[r] + column + kLanes, &right[r], sizeof(Register));
    }
  }
}

STRIDEGRAPH_WIDE void multiplyWide(const float* packed, const ProductColumns& columns,
                                   const std::array<float*, kProductRows>& products) {
  multiplyWith<WideLanes>(packed, columns, products);
}

}  // namespace

void multiplyRows(const float* packed, const ProductColumns& columns,
                  const std::array<float*, kProductRows>& products) {
  if (hasWideRegisters()) return multiplyWide(packed, columns, products);
  multiplyWith<Lanes>(packed, columns, products);
}

}  // namespace stridegraph
