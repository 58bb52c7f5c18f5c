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

/// Heights of one row and two registers of columns.
template <typename Register>
struct HeightSums {
  Register left{};
  Register right{};

  STRIDEGRAPH_INLINE void add(float rowY, const Register& leftY, const Register& rightY) {
    left += rowY * leftY;
    right += rowY * rightY;
  }
  STRIDEGRAPH_INLINE void store(const ProductTargets& targets, std::size_t row) const {
    std::memcpy(targets.height + row * targets.stride, &left, sizeof(Register));
    std::memcpy(targets.height + row * targets.stride + sizeof(Register) / sizeof(float), &right,
                sizeof(Register));
  }
};

/// Two registers of columns at once, `apart` floats from one another: so that eight sums keep the adders
/// busy.
template <typename Register, std::size_t kPoint>
STRIDEGRAPH_INLINE void multiplyHeights(Operands operands, std::size_t apart, const ProductTargets& targets) {
  HeightSums<Register> first;
  HeightSums<Register> second;
  HeightSums<Register> third;
  HeightSums<Register> fourth;
  operands.factors += 2 * kPanelColumns;
  operands.columns += 2 * kPanelColumns;
  for (; operands.points != 0; --operands.points, operands.factors += kPoint, operands.columns += kPoint) {
    Register left;
    Register right;
    std::memcpy(&left, operands.columns, sizeof(left));
    std::memcpy(&right, operands.columns + apart, sizeof(right));
    first.add(operands.factors[0], left, right);
    second.add(operands.factors[1], left, right);
    third.add(operands.factors[2], left, right);
    fourth.add(operands.factors[3], left, right);
  }
  first.store(targets, 0);
  second.store(targets, 1);
  third.store(targets, 2);
  fourth.store(targets, 3);
}

/// Heights come in a loop of their own: with all sums at once, some would be kept in memory.
template <typename Register, PointTerms kTerms>
STRIDEGRAPH_INLINE void multiplyWith(const float* factors, const ProductColumns& columns,
                                     ProductTargets targets) {
  static_assert(kProductRows == 4);
  constexpr std::size_t kLanes = sizeof(Register) / sizeof(float);
  constexpr std::size_t kPoint = static_cast<std::size_t>(kTerms) * kPanelColumns;
  const std::size_t panelFloats = kPoint * columns.points;
  const std::size_t apart = kLanes < kPanelColumns ? kLanes : panelFloats;
  const std::size_t first = columns.begin / kPanelColumns * kPanelColumns;
  targets.along += first;
  targets.across += first;
  if constexpr (kTerms == PointTerms::kSpace) targets.height += first;
  const float* panel = columns.panels->columns.data() + first / kPanelColumns * panelFloats;
  bool hasHeights = false;
  for (std::size_t column = first; column < columns.end; column += kPanelColumns, panel += panelFloats) {
    for (std::size_t lane = 0; lane < kPanelColumns; lane += kLanes) {
      const Operands operands{factors, panel + lane, columns.points};
      multiplyFloor<Register, kPoint>(operands, targets);
      targets.along += kLanes;
      targets.across += kLanes;
      if constexpr (kTerms == PointTerms::kSpace) {
        if (!hasHeights) multiplyHeights<Register, kPoint>(operands, apart, targets);
        hasHeights = !hasHeights;
        targets.height += kLanes;
      }
    }
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
