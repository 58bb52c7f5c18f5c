#pragma once

#include <array>
#include <cstddef>

namespace stridegraph {

/// Rows that are multiplied at once.
inline constexpr std::size_t kProductRows = 4;

/// Columns come in panels of this many: as many floats as a register of AVX2 holds, or two of WebAssembly.
inline constexpr std::size_t kPanelColumns = 8;

/// One term of the columns of a panel. A panel is all its terms in a row, a matrix all its panels in a row:
/// products then read memory from its beginning to its end.
struct alignas(sizeof(float) * kPanelColumns) PanelTerm {
  std::array<float, kPanelColumns> columns{};
};

/// What is multiplied: points on the floor with or without heights. Terms are x, z and, in the first case, y
/// of the first point, then those of the next.
enum class PointTerms : std::size_t { kFloor = 2, kSpace = 3 };

/// Columns begin..end of `panels` and some beyond, up to the ends of their panels, and of heights the panel
/// behind these, too: there must be one more, and room for its products.
struct ProductColumns {
  const PanelTerm* panels = nullptr;
  std::size_t points = 0;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Where products go: those of a row begin `stride` floats after those of the row before.
struct ProductTargets {
  float* along = nullptr;   ///< Sums of x x' + z z',
  float* across = nullptr;  ///< of x z' - z x',
  float* height = nullptr;  ///< and of y y'; not touched where there are no heights.
  std::size_t stride = 0;
};

/// Multiplies kProductRows rows, which are the columns `row` and on of the matrix of panels `rows` (a
/// multiple of kProductRows; as many points as the columns), with columns. Sums run over the points in their
/// order, whatever the width of the machine's registers; that of `along` adds x x', then z z' of a point,
/// that of `across` adds x z', then takes off z x'.
void multiplyRows(const PanelTerm* rows, std::size_t row, PointTerms terms, const ProductColumns& columns,
                  const ProductTargets& targets);

}  // namespace stridegraph
