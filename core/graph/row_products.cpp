#include "graph/row_products.h"

#include <cstring>

#include "base/wide.h"

namespace stridegraph {
namespace {

static_assert(kPanelColumns % kProductRows == 0);

// Four floats in a register of x86-64 or WebAssembly alike; GCC and Clang lower it to plain code elsewhere.
using Lanes = float __attribute__((vector_size(16)));
using WideLanes = float __attribute__((vector_size(32)));

/// Along and across of one row. Not arrays of sums, which compilers put into memory rather than registers.
template <typename Register>
struct FloorSums {
  Register along{};
  Register across{};

  STRIDEGRAPH_INLINE void add(const float* factors, const Register& x, const Register& z) {
    const float rowX = factors[0];
    const float rowZ = factors[kPanelColumns];
    along += rowX * x;
    across += rowX * z;
    along += rowZ * z;
    across -= rowZ * x;
  }
  STRIDEGRAPH_INLINE void store(const ProductTargets& targets, std::size_t row) const {
    std::memcpy(targets.along + row * targets.stride, &along, sizeof(Register));
    std::memcpy(targets.across + row * targets.stride, &across, sizeof(Register));
  }
};

/// The rows that are multiplied and a register of columns; all terms of a point take kPoint floats.
struct Operands {
  const float* factors;
  const float* columns;
  std::size_t points;
};

template <typename Register, std::size_t kPoint>
STRIDEGRAPH_INLINE void multiplyFloor(Operands operands, const ProductTargets& targets) {
  FloorSums<Register> first;
  FloorSums<Register> second;
  FloorSums<Register> third;
  FloorSums<Register> fourth;
  for (; operands.points != 0; --operands.points, operands.factors += kPoint, operands.columns += kPoint) {
    Register x;
    Register z;
    std::memcpy(&x, operands.columns, sizeof(x));
    std::memcpy(&z, operands.columns + kPanelColumns, sizeof(z));
    first.add(operands.factors, x, z);
    second.add(operands.factors + 1, x, z);
    third.add(operands.factors + 2, x, z);
    fourth.add(operands.factors + 3, x, z);
  }
  first.store(targets, 0);
  second.store(targets, 1);
  third.store(targets, 2);
  fourth.store(targets, 3);
}

template <typename Register, std::size_t kPoint>
STRIDEGRAPH_INLINE void multiplyHeights(Operands operands, const ProductTargets& targets) {
  Register first{};
  Register second{};
  Register third{};
  Register fourth{};
  operands.factors += 2 * kPanelColumns;
  operands.columns += 2 * kPanelColumns;
  for (; operands.points != 0; --operands.points, operands.factors += kPoint, operands.columns += kPoint) {
    Register y;
    std::memcpy(&y, operands.columns, sizeof(y));
    first += operands.factors[0] * y;
    second += operands.factors[1] * y;
    third += operands.factors[2] * y;
    fourth += operands.factors[3] * y;
  }
  std::memcpy(targets.height, &first, sizeof(Register));
  std::memcpy(targets.height + targets.stride, &second, sizeof(Register));
  std::memcpy(targets.height + 2 * targets.stride, &third, sizeof(Register));
  std::memcpy(targets.height + 3 * targets.stride, &fourth, sizeof(Register));
}

/// All sums of one register of columns. Heights come in a second loop: with all twelve sums at once, some
/// would be kept in memory.
template <typename Register, PointTerms kTerms>
STRIDEGRAPH_INLINE void multiplyRegister(const Operands& operands, const ProductTargets& targets) {
  constexpr std::size_t kPoint = static_cast<std::size_t>(kTerms) * kPanelColumns;
  static_assert(kProductRows == 4);
  multiplyFloor<Register, kPoint>(operands, targets);
  if constexpr (kTerms == PointTerms::kSpace) multiplyHeights<Register, kPoint>(operands, targets);
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
      multiplyRegister<Register, kTerms>({factors, panel->columns.data() + lane, columns.points}, targets);
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
