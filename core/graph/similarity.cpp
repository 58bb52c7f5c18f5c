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

static_assert(kWindowFrames <= kPanelColumns && kWindowFrames <= DistanceRows::kRowsAtOnce + 1);

/// One product of the frames of a window, down a diagonal of the ring.
using Diagonal = std::array<const float*, kWindowFrames>;

/// All that the distances of one row are made of; columns begin..end.
struct RowParts {
  Diagonal along;
  Diagonal across;
  Diagonal height;
  const float* motionAlong = nullptr;
  const float* motionAcross = nullptr;
  const float* energies = nullptr;
  float energy = 0.0F;
  std::size_t begin = 0;
  std::size_t end = 0;
};

STRIDEGRAPH_INLINE float sumAlong(const Diagonal& diagonal, float start, std::size_t column) {
  for (std::size_t d = 0; d < kWindowFrames; ++d) start += diagonal[d][column];
  return start;
}

STRIDEGRAPH_INLINE void combineColumns(const RowParts& parts, std::uint32_t* __restrict distances) {
  constexpr auto kScale = static_cast<float>(kMicrometresPerMetre);
  constexpr auto kLimit = static_cast<float>(kFarMicrometres);
  // Copies, so that the compiler need not fear for the pointers when it writes.
  const Diagonal along = parts.along;
  const Diagonal across = parts.across;
  const Diagonal height = parts.height;
  const float* motionAlong = parts.motionAlong;
  const float* motionAcross = parts.motionAcross;
  const float* energies = parts.energies;
  const float energy = parts.energy;
  const std::size_t end = parts.end;
  for (std::size_t c = parts.begin; c < end; ++c) {
    const float a = sumAlong(along, motionAlong[c], c);
    const float b = sumAlong(across, motionAcross[c], c);
    const float h = sumAlong(height, 0.0F, c);
    const float squared = (energy + energies[c]) - 2.0F * (std::sqrt(a * a + b * b) + h);
    const float micrometres = std::sqrt(squared > 0.0F ? squared : 0.0F) * kScale + 0.5F;
    distances[c] =
        static_cast<std::uint32_t>(static_cast<std::int32_t>(micrometres < kLimit ? micrometres : kLimit));
  }
}

STRIDEGRAPH_WIDE void combineWide(const RowParts& parts, std::uint32_t* distances) {
  combineColumns(parts, distances);
}

}  // namespace

DistanceRows::DistanceRows(const ClipFeatures& rows, const ClipFeatures& columns) {
  restart(rows, columns);
}

DistanceRows::DistanceRows(const ClipFeatures& clip, std::size_t reach) {
  restart(clip, reach);
}

void DistanceRows::restart(const ClipFeatures& rows, const ClipFeatures& columns) {
  STRIDEGRAPH_CHECK(rows.jointCount() == columns.jointCount());
  rows_ = &rows;
  columns_ = &columns;
  reach_ = std::numeric_limits<std::size_t>::max();
  stride_ = columns.paddedCount() + kPanelColumns;
  nextRow_ = 0;
  firstColumn_ = 0;
  // Products of other clips may stay: they only reach columns behind the last window.
  for (std::vector<float>* ring : {&along_, &across_, &height_}) ring->resize(kRing * stride_);
  for (std::vector<float>* products : {&motionAlong_, &motionAcross_})
    products->resize(kRowsAtOnce * stride_);
  distances_.resize(kRowsAtOnce * stride_);
}

void DistanceRows::restart(const ClipFeatures& clip, std::size_t reach) {
  restart(clip, clip);
  reach_ = reach;
}

std::size_t DistanceRows::firstColumnFor(std::size_t row) const {
  return row > reach_ ? row - reach_ : 0;
}

std::span<const std::uint32_t> DistanceRows::row(std::size_t k) const {
  return std::span(distances_).subspan(k * stride_, columns_->windowCount());
}

void DistanceRows::multiplyFrames(std::size_t firstFrame) {
  if (firstFrame >= rows_->frameCount()) return;
  const std::size_t begin = firstColumnFor(firstFrame > kRowsAtOnce ? firstFrame - kRowsAtOnce : 0);
  const std::size_t slot = firstFrame % kRing * stride_;
  multiplyRows(rows_->frames(), firstFrame, PointTerms::kSpace,
               {columns_->frames(), columns_->jointCount(), begin, columns_->frameCount()},
               {along_.data() + slot, across_.data() + slot, height_.data() + slot, stride_});
}

std::size_t DistanceRows::advance() {
  if (rows_ == nullptr) return 0;
  const std::size_t rowCount = rows_->windowCount();
  if (nextRow_ >= rowCount || columns_->windowCount() == 0) return 0;
  if (nextRow_ == 0) multiplyFrames(0);
  multiplyFrames(nextRow_ + kRowsAtOnce);
  firstColumn_ = firstColumnFor(nextRow_);
  multiplyRows(rows_->motion(), nextRow_, PointTerms::kFloor,
               {columns_->motion(), ClipFeatures::kMotionPoints, firstColumn_, columns_->windowCount()},
               {motionAlong_.data(), motionAcross_.data(), nullptr, stride_});
  const std::size_t count = std::min(kRowsAtOnce, rowCount - nextRow_);
  for (std::size_t k = 0; k < count; ++k) combine(nextRow_ + k, k);
  nextRow_ += count;
  return count;
}

void DistanceRows::combine(std::size_t row, std::size_t k) {
  RowParts parts;
  for (std::size_t d = 0; d < kWindowFrames; ++d) {
    const std::size_t shift = (row + d) % kRing * stride_ + d;
    parts.along[d] = along_.data() + shift;
    parts.across[d] = across_.data() + shift;
    parts.height[d] = height_.data() + shift;
  }
  parts.motionAlong = motionAlong_.data() + k * stride_;
  parts.motionAcross = motionAcross_.data() + k * stride_;
  parts.energies = columns_->energies();
  parts.energy = rows_->energies()[row];
  // Whole panels, so that no column is done one by one.
  parts.begin = firstColumn_ / kPanelColumns * kPanelColumns;
  parts.end = (columns_->windowCount() + kPanelColumns - 1) / kPanelColumns * kPanelColumns;
  std::uint32_t* distances = distances_.data() + k * stride_;
  if (hasWideRegisters()) return combineWide(parts, distances);
  combineColumns(parts, distances);
}

}  // namespace stridegraph
