#include "graph/row_products.h"

#include <cstring>

#include "base/wide.h"

namespace stridegraph {
namespace {

static_assert(kPanelColumns % kProductRows == 0);

// Four floats in a register of x86-64 or WebAssembly alike; GCC and Clang lower it to plain code elsewhere.
using Lanes = float __attribute__((vector_size(16)));
using WideLanes = float __attribute__((vector_size(32)));

/// The sums of one row. Not arrays of sums, which compilers put into memory rather than registers.
template <typename Register>
struct RowSums {
  Register along{};
  Register across{};
  Register height{};

  STRIDEGRAPH_INLINE void addFloor(const float* factors, const Register& x, const Register& z) {
    const float rowX = factors[0];
    const float rowZ = factors[kPanelColumns];
    along += rowX * x;
    across += rowX * z;
    along += rowZ * z;
    across -= rowZ * x;
  }
  STRIDEGRAPH_INLINE void addHeight(const float* factors, const Register& y) {
    height += factors[2 * kPanelColumns] * y;
  }
};

template <PointTerms kTerms, typename Register>
STRIDEGRAPH_INLINE void store(const RowSums<Register>& sums, const ProductTargets& targets, std::size_t row) {
  std::memcpy(targets.along + row * targets.stride, &sums.along, sizeof(Register));
  std::memcpy(targets.across + row * targets.stride, &sums.across, sizeof(Register));
  if constexpr (kTerms == PointTerms::kSpace)
    std::memcpy(targets.height + row * targets.stride, &sums.height, sizeof(Register));
}

/// All sums of one register of columns at once: as many as keep the adders busy without spilling.
template <typename Register, PointTerms kTerms>
STRIDEGRAPH_INLINE void multiplyRegister(const float* factors, const float* terms, std::size_t points,
                                         const ProductTargets& targets) {
  constexpr std::size_t kPoint = static_cast<std::size_t>(kTerms) * kPanelColumns;
  static_assert(kProductRows == 4);
  RowSums<Register> first;
  RowSums<Register> second;
  RowSums<Register> third;
  RowSums<Register> fourth;
  for (std::size_t p = 0; p < points; ++p, factors += kPoint, terms += kPoint) {
    Register x;
    Register z;
    std::memcpy(&x, terms, sizeof(x));
    std::memcpy(&z, terms + kPanelColumns, sizeof(z));
    first.addFloor(factors, x, z);
    second.addFloor(factors + 1, x, z);
    third.addFloor(factors + 2, x, z);
    fourth.addFloor(factors + 3, x, z);
    if constexpr (kTerms == PointTerms::kSpace) {
      Register y;
      std::memcpy(&y, terms + 2 * kPanelColumns, sizeof(y));
      first.addHeight(factors, y);
      second.addHeight(factors + 1, y);
      third.addHeight(factors + 2, y);
      fourth.addHeight(factors + 3, y);
    }
  }
  store<kTerms>(first, targets, 0);
  store<kTerms>(second, targets, 1);
  store<kTerms>(third, targets, 2);
  store<kTerms>(fourth, targets, 3);
}

template <typename Register, PointTerms kTerms>
STRIDEGRAPH_INLINE void multiplyWith(const float* factors, const ProductColumns& columns,
                                     ProductTargets targets) {
  constexpr std::size_t kLanes = sizeof(Register) / sizeof(float);
  const std::size_t panelTerms = static_cast<std::size_t>(kTerms) * columns.points;
  const std::size_t firstPanel = columns.begin / kPanelColumns;
  const PanelTerm* panel = columns.panels + firstPanel * panelTerms;
  targets.along += firstPanel * kPanelColumns;
  targets.across += firstPanel * kPanelColumns;
  if constexpr (kTerms == PointTerms::kSpace) targets.height += firstPanel * kPanelColumns;
  for (std::size_t column = firstPanel * kPanelColumns; column < columns.end; column += kPanelColumns) {
    for (std::size_t lane = 0; lane < kPanelColumns; lane += kLanes) {
      multiplyRegister<Register, kTerms>(factors, panel->columns.data() + lane, columns.points, targets);
      targets.along += kLanes;
      targets.across += kLanes;
      if constexpr (kTerms == PointTerms::kSpace) targets.height += kLanes;
    }
    panel += panelTerms;
  }
}

template <typename Register>
STRIDEGRAPH_INLINE void multiplyTerms(const float* factors, PointTerms terms, const ProductColumns& columns,
                                      const ProductTargets& targets) {
  if (terms == PointTerms::kSpace)
    return multiplyWith<Register, PointTerms::kSpace>(factors, columns, targets);
  multiplyWith<Register, PointTerms::kFloor>(factors, columns, targets);
}

STRIDEGRAPH_WIDE void multiplyWide(const float* factors, PointTerms terms, const ProductColumns& columns,
                                   const ProductTargets& targets) {
  multiplyTerms<WideLanes>(factors, terms, columns, targets);
}

}  // namespace

void multiplyRows(const PanelTerm* rows, std::size_t row, PointTerms terms, const ProductColumns& columns,
                  const ProductTargets& targets) {
  const std::size_t panelTerms = static_cast<std::size_t>(terms) * columns.points;
  const float* factors = rows[row / kPanelColumns * panelTerms].columns.data() + row % kPanelColumns;
  if (hasWideRegisters()) return multiplyWide(factors, terms, columns, targets);
  multiplyTerms<Lanes>(factors, terms, columns, targets);
}

}  // namespace stridegraph
