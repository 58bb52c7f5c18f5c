#include "graph/transition_scan.h"

#include <algorithm>

#include "graph/pose_distance.h"

namespace stridegraph {
namespace {

/// About a millisecond of work.
constexpr std::size_t kPairsInAStep = 40'000;

double cellsOf(const ClipFeatures& a, const ClipFeatures& b) {
  return static_cast<double>(a.windowCount()) * static_cast<double>(b.windowCount());
}

}  // namespace

TransitionScan::TransitionScan(std::vector<ClipFeatures> clips, const ValleyParams& params,
                               KnownRegions known)
    : clips_(std::move(clips)), knownClips_(std::move(known.clips)), valleys_(params) {
  found_.reserve(known.regions.size());
  for (const AlikeRegion& region : known.regions) found_.push_back({region, 0});
  std::size_t start = 0;
  for (std::size_t a = 0; a < clips_.size(); ++a) {
    starts_.push_back(start);
    start += clips_[a].frameCount();
    for (std::size_t b = a; b < clips_.size(); ++b) {
      if (!isKnown(a) || !isKnown(b)) allCells_ += cellsOf(clips_[a], clips_[b]);
    }
  }
  if (!clips_.empty() && isKnownPair()) nextPair();
}

double TransitionScan::progress() const {
  if (first_ >= clips_.size() || allCells_ == 0.0) return 1.0;
  return std::min(1.0, doneCells_ / allCells_);
}

void TransitionScan::beginPair() {
  const std::size_t columns = clips_[second_].windowCount();
  if (first_ == second_) {
    valleys_.restartOfOneClip(columns);
    rows_.restart(clips_[first_], valleys_.reach());
  } else {
    valleys_.restart(columns);
    rows_.restart(clips_[first_], clips_[second_]);
  }
  pairIsBegun_ = true;
}

void TransitionScan::endPair() {
  const auto frame = [&](std::size_t clip, std::size_t window) {
    return FrameIndex(starts_[clip] + window + kWindowReach);
  };
  for (const Region& region : valleys_.finish()) {
    found_.push_back(
        {{frame(first_, region.row), frame(second_, region.column),
          static_cast<std::uint16_t>(region.rowSpan), static_cast<std::uint16_t>(region.columnSpan),
          static_cast<float>(region.meanDistanceMetres)},
         region.largestMicrometres});
  }
  pairIsBegun_ = false;
  nextPair();
}

void TransitionScan::nextPair() {
  do {
    if (++second_ == clips_.size()) second_ = ++first_;
  } while (first_ < clips_.size() && isKnownPair());
}

bool TransitionScan::step() {
  std::size_t work = 0;
  while (first_ < clips_.size() && work < kPairsInAStep) {
    if (!pairIsBegun_) beginPair();
    const std::size_t count = rows_.advance();
    for (std::size_t k = 0; k < count; ++k) valleys_.addRow(rows_.row(k), rows_.firstColumn());
    const std::size_t columns = clips_[second_].windowCount();
    const std::size_t pairs = count * (columns - std::min(columns, rows_.firstColumn()));
    doneCells_ += static_cast<double>(count * columns);
    framePairs_ += pairs;
    // Even a pair of clips without any windows costs a little, so that a step stays short.
    work += pairs + 1000;
    if (count == 0) endPair();
  }
  return first_ < clips_.size();
}

std::vector<AlikeRegion> TransitionScan::take() {
  std::vector<AlikeRegion> regions;
  regions.reserve(found_.size());
  for (const ScannedRegion& found : takeScanned()) regions.push_back(found.region);
  return regions;
}

std::vector<ScannedRegion> TransitionScan::takeScanned() {
  std::sort(found_.begin(), found_.end());
  return std::move(found_);
}

}  // namespace stridegraph
