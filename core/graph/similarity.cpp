#include "graph/similarity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "base/wide.h"
#include "graph/pose_distance.h"
#include "graph/row_products.h"
#include "graph/window_sums.h"

namespace stridegraph {
namespace {

static_assert(DistanceRows::kRowsAtOnce == kWindowsAtOnce);

/// One product of the frames that four rows of windows span, each shifted by a column more than that before:
/// down a diagonal.
using Diagonal = std::array<const float*, kFramesOfWindows>;

/// All that the distances of four rows are made of. Every row is shifted by a column more than that before,
/// so that the windows of column c lie on one diagonal.
struct QuadParts {
  Diagonal along;
  Diagonal across;
  Diagonal height;
  std::array<const float*, kWindowsAtOnce> motionAlong;
  std::array<const float*, kWindowsAtOnce> motionAcross;
  std::array<const float*, kWindowsAtOnce> columnEnergies;
  std::array<float, kWindowsAtOnce> rowEnergies;
  std::array<std::uint32_t*, kWindowsAtOnce> distances;
  std::size_t columns = 0;
};

STRIDEGRAPH_INLINE std::array<float, kWindowsAtOnce> sumsAlong(const Diagonal& d, std::size_t c) {
  return windowSums({d[0][c], d[1][c], d[2][c], d[3][c], d[4][c], d[5][c], d[6][c], d[7][c]});
}

STRIDEGRAPH_INLINE std::uint32_t micrometresOf(float along, float across, float height, float energy) {
  constexpr auto kScale = static_cast<float>(kMicrometresPerMetre);
  constexpr auto kLimit = static_cast<float>(kFarMicrometres);
  const float squared = energy - 2.0F * (std::sqrt(along * along + across * across) + height);
  const float micrometres = std::sqrt(squared > 0.0F ? squared : 0.0F) * kScale + 0.5F;
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(micrometres < kLimit ? micrometres : kLimit));
}

STRIDEGRAPH_INLINE void combineColumns(const QuadParts& given) {
  // A copy and pointers of their own, so that the compiler need not fear for what it reads when it writes.
  const QuadParts parts = given;
  std::uint32_t* __restrict first = parts.distances[0];
  std::uint32_t* __restrict second = parts.distances[1];
  std::uint32_t* __restrict third = parts.distances[2];
  std::uint32_t* __restrict fourth = parts.distances[3];
  for (std::size_t c = 0; c < parts.columns; ++c) {
    const std::array<float, kWindowsAtOnce> along = sumsAlong(parts.along, c);
    const std::array<float, kWindowsAtOnce> across = sumsAlong(parts.across, c);
    const std::array<float, kWindowsAtOnce> height = sumsAlong(parts.height, c);
    const auto distance = [&](std::size_t k) {
      return micrometresOf(parts.motionAlong[k][c] + along[k], parts.motionAcross[k][c] + across[k],
                           height[k], parts.rowEnergies[k] + parts.columnEnergies[k][c]);
    };
    first[c] = distance(0);
    second[c] = distance(1);
    third[c] = distance(2);
    fourth[c] = distance(3);
  }
}

STRIDEGRAPH_WIDE void combineWide(const QuadParts& parts) {
  combineColumns(parts);
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
  stride_ = kLead + columns.paddedCount() + kTail;
  nextRow_ = 0;
  firstColumn_ = 0;
  // Products of other clips may stay: they only reach columns behind the last window.
  for (std::vector<float>* ring : {&along_, &across_, &height_}) ring->resize(kRing * stride_);
  for (std::vector<float>* products : {&motionAlong_, &motionAcross_})
    products->resize(kRowsAtOnce * stride_);
  distances_.resize(kRowsAtOnce * stride_);
  energies_.resize(stride_);
  std::copy_n(columns.energies(), columns.paddedCount(), energies_.begin() + kLead);
}

void DistanceRows::restart(const ClipFeatures& clip, std::size_t reach) {
  restart(clip, clip);
  reach_ = reach;
}

std::size_t DistanceRows::firstColumnFor(std::size_t row) const {
  return row > reach_ ? row - reach_ : 0;
}

std::span<const std::uint32_t> DistanceRows::row(std::size_t k) const {
  return std::span(distances_).subspan(k * stride_ + kLead, columns_->windowCount());
}

void DistanceRows::multiplyFrames(std::size_t firstFrame) {
  if (firstFrame >= rows_->frameCount()) return;
  const std::size_t begin = firstColumnFor(firstFrame > kRowsAtOnce ? firstFrame - kRowsAtOnce : 0);
  const std::size_t slot = firstFrame % kRing * stride_ + kLead;
  multiplyRows(rows_->frames(), firstFrame, PointTerms::kSpace,
               {columns_->frames(), columns_->jointCount(), begin, columns_->frameCount()},
               {along_.data() + slot, across_.data() + slot, height_.data() + slot, stride_});
}

void DistanceRows::multiplyMotion() {
  multiplyRows(rows_->motion(), nextRow_, PointTerms::kFloor,
               {columns_->motion(), ClipFeatures::kMotionPoints, firstColumn_, columns_->windowCount()},
               {motionAlong_.data() + kLead, motionAcross_.data() + kLead, nullptr, stride_});
}

std::size_t DistanceRows::advance() {
  if (rows_ == nullptr) return 0;
  const std::size_t rowCount = rows_->windowCount();
  if (nextRow_ >= rowCount || columns_->windowCount() == 0) return 0;
  if (nextRow_ == 0) multiplyFrames(0);
  multiplyFrames(nextRow_ + kRowsAtOnce);
  firstColumn_ = firstColumnFor(nextRow_);
  multiplyMotion();
  combine();
  const std::size_t count = std::min(kRowsAtOnce, rowCount - nextRow_);
  nextRow_ += count;
  return count;
}

void DistanceRows::combine() {
  // The last row is shifted the most to the right.
  const std::size_t begin = kLead + firstColumn_ - (kWindowsAtOnce - 1);
  const std::size_t needed = kLead + columns_->windowCount() - begin;
  QuadParts parts;
  for (std::size_t d = 0; d < kFramesOfWindows; ++d) {
    const std::size_t shift = (nextRow_ + d) % kRing * stride_ + begin + d;
    parts.along[d] = along_.data() + shift;
    parts.across[d] = across_.data() + shift;
    parts.height[d] = height_.data() + shift;
  }
  for (std::size_t k = 0; k < kWindowsAtOnce; ++k) {
    const std::size_t shift = k * stride_ + begin + k;
    parts.motionAlong[k] = motionAlong_.data() + shift;
    parts.motionAcross[k] = motionAcross_.data() + shift;
    parts.columnEnergies[k] = energies_.data() + begin + k;
    parts.rowEnergies[k] = rows_->energies()[nextRow_ + k];
    parts.distances[k] = distances_.data() + shift;
  }
  // Whole panels, so that no column is done one by one.
  parts.columns = (needed + kPanelColumns - 1) / kPanelColumns * kPanelColumns;
  if (hasWideRegisters()) return combineWide(parts);
  combineColumns(parts);
}

}  // namespace stridegraph
