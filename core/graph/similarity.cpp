#include "graph/similarity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "base/wide.h"
#include "graph/pose_distance.h"
#include "graph/row_products.h"

namespace stridegraph {
namespace {

static_assert(DistanceRows::kRowsAtOnce == kProductRows);
static_assert(ClipFeatures::kPadding >= kProductColumns + kWindowFrames);

/// Four neighbouring columns of `terms` terms, term by term; columns from `limit` on count as zeros.
struct Block {
  const float* first;
  std::size_t stride;
  std::size_t terms;
  std::size_t column;
  std::size_t limit;

  float at(std::size_t term, std::size_t r) const {
    return column + r < limit ? first[term * stride + column + r] : 0.0F;
  }
};

std::vector<float> packed(const Block& block) {
  std::vector<float> result(block.terms * kProductRows);
  for (std::size_t t = 0; t < block.terms; ++t) {
    for (std::size_t r = 0; r < kProductRows; ++r) result[t * kProductRows + r] = block.at(t, r);
  }
  return result;
}

/// The same floor points turned by a right angle, so that their product is the cross product: terms hold all
/// x, then all z, and x x' + z z' becomes x z' - z x'.
std::vector<float> packedAcross(const Block& block) {
  const std::size_t half = block.terms / 2;
  std::vector<float> result(block.terms * kProductRows);
  for (std::size_t t = 0; t < half; ++t) {
    for (std::size_t r = 0; r < kProductRows; ++r) {
      result[t * kProductRows + r] = -block.at(half + t, r);
      result[(half + t) * kProductRows + r] = block.at(t, r);
    }
  }
  return result;
}

std::array<float*, kProductRows> rowsFrom(std::vector<float>& storage, std::size_t first,
                                          std::size_t stride) {
  std::array<float*, kProductRows> rows;
  for (std::size_t r = 0; r < kProductRows; ++r) rows[r] = storage.data() + (first + r) * stride;
  return rows;
}

/// One product of the frames of a window, down a diagonal of the ring.
using Diagonal = std::array<const float*, kWindowFrames>;

/// All that the distances of one row are made of; columns begin..end.
struct RowParts {
  Diagonal along;
  Diagonal across;
  Diagonal height;
  const float* motionAlong = nullptr;
  const float* motionAcross = nullptr;
  const double* energies = nullptr;
  double energy = 0.0;
  std::size_t begin = 0;
  std::size_t end = 0;
};

STRIDEGRAPH_INLINE double sumAlong(const Diagonal& diagonal, double start, std::size_t column) {
  for (std::size_t d = 0; d < kWindowFrames; ++d) start += static_cast<double>(diagonal[d][column]);
  return start;
}

STRIDEGRAPH_INLINE void combineColumns(const RowParts& parts, std::uint32_t* __restrict distances) {
  constexpr double kLimit = kFarMicrometres;
  // Copies, so that the compiler need not fear for the pointers when it writes.
  const Diagonal along = parts.along;
  const Diagonal across = parts.across;
  const Diagonal height = parts.height;
  const float* motionAlong = parts.motionAlong;
  const float* motionAcross = parts.motionAcross;
  const double* energies = parts.energies;
  const double energy = parts.energy;
  const std::size_t end = parts.end;
  for (std::size_t c = parts.begin; c < end; ++c) {
    const double a = sumAlong(along, static_cast<double>(motionAlong[c]), c);
    const double b = sumAlong(across, static_cast<double>(motionAcross[c]), c);
    const double h = sumAlong(height, 0.0, c);
    const double squared = energy + energies[c] - 2.0 * (std::sqrt(a * a + b * b) + h);
    const double micrometres = std::sqrt(squared > 0.0 ? squared : 0.0) * kMicrometresPerMetre + 0.5;
    distances[c] =
        static_cast<std::uint32_t>(static_cast<std::int32_t>(micrometres < kLimit ? micrometres : kLimit));
  }
}

STRIDEGRAPH_WIDE void combineWide(const RowParts& parts, std::uint32_t* distances) {
  combineColumns(parts, distances);
}

}  // namespace

DistanceRows::DistanceRows(const ClipFeatures& rows, const ClipFeatures& columns)
    : rows_(&rows),
      columns_(&columns),
      reach_(std::numeric_limits<std::size_t>::max()),
      along_(kRing * columns.stride(), 0.0F),
      across_(kRing * columns.stride(), 0.0F),
      height_(kRing * columns.stride(), 0.0F),
      motionAlong_(kRowsAtOnce * columns.stride(), 0.0F),
      motionAcross_(kRowsAtOnce * columns.stride(), 0.0F),
      distances_(kRowsAtOnce * columns.stride(), 0) {
  STRIDEGRAPH_CHECK(rows.jointCount() == columns.jointCount());
}

DistanceRows::DistanceRows(const ClipFeatures& clip, std::size_t reach) : DistanceRows(clip, clip) {
  reach_ = reach;
}

std::size_t DistanceRows::firstColumnFor(std::size_t row) const {
  return row > reach_ ? row - reach_ : 0;
}

std::span<const std::uint32_t> DistanceRows::row(std::size_t k) const {
  return std::span(distances_).subspan(k * columns_->stride(), columns_->windowCount());
}

void DistanceRows::multiplyFrames(std::size_t firstFrame) {
  const std::size_t stride = columns_->stride();
  const std::size_t begin = firstColumnFor(firstFrame > kRowsAtOnce ? firstFrame - kRowsAtOnce : 0);
  ProductColumns columns{columns_->planar(), stride, 2 * columns_->jointCount(), begin,
                         columns_->frameCount()};
  Block block{rows_->planar(), rows_->stride(), 2 * rows_->jointCount(), firstFrame, rows_->frameCount()};
  const std::size_t slot = firstFrame % kRing;
  multiplyRows(packed(block).data(), columns, rowsFrom(along_, slot, stride));
  multiplyRows(packedAcross(block).data(), columns, rowsFrom(across_, slot, stride));
  columns.first = columns_->heights();
  block.first = rows_->heights();
  columns.terms = block.terms = rows_->jointCount();
  multiplyRows(packed(block).data(), columns, rowsFrom(height_, slot, stride));
}

std::size_t DistanceRows::advance() {
  const std::size_t rowCount = rows_->windowCount();
  if (nextRow_ >= rowCount || columns_->windowCount() == 0) return 0;
  if (nextRow_ == 0) multiplyFrames(0);
  multiplyFrames(nextRow_ + kRowsAtOnce);
  firstColumn_ = firstColumnFor(nextRow_);
  const ProductColumns columns{columns_->motion(), columns_->stride(), ClipFeatures::kMotionTerms,
                               firstColumn_, columns_->windowCount()};
  const Block block{rows_->motion(), rows_->stride(), ClipFeatures::kMotionTerms, nextRow_, rowCount};
  multiplyRows(packed(block).data(), columns, rowsFrom(motionAlong_, 0, columns_->stride()));
  multiplyRows(packedAcross(block).data(), columns, rowsFrom(motionAcross_, 0, columns_->stride()));
  const std::size_t count = std::min(kRowsAtOnce, rowCount - nextRow_);
  for (std::size_t k = 0; k < count; ++k) combine(nextRow_ + k, k);
  nextRow_ += count;
  return count;
}

void DistanceRows::combine(std::size_t row, std::size_t k) {
  const std::size_t stride = columns_->stride();
  RowParts parts;
  for (std::size_t d = 0; d < kWindowFrames; ++d) {
    const std::size_t shift = (row + d) % kRing * stride + d;
    parts.along[d] = along_.data() + shift;
    parts.across[d] = across_.data() + shift;
    parts.height[d] = height_.data() + shift;
  }
  parts.motionAlong = motionAlong_.data() + k * stride;
  parts.motionAcross = motionAcross_.data() + k * stride;
  parts.energies = columns_->energies();
  parts.energy = rows_->energies()[row];
  parts.begin = firstColumn_;
  parts.end = columns_->windowCount();
  std::uint32_t* distances = distances_.data() + k * stride;
  if (hasWideRegisters()) return combineWide(parts, distances);
  combineColumns(parts, distances);
}

}  // namespace stridegraph
