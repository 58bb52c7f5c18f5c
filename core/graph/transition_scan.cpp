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

TransitionScan::TransitionScan(std::vector<ClipFeatures> clips, const ValleyParams& params)
    : clips_(std::move(clips)), params_(params) {
  for (std::size_t a = 0; a < clips_.size(); ++a) {
    for (std::size_t b = a; b < clips_.size(); ++b) allCells_ += cellsOf(clips_[a], clips_[b]);
  }
}

double TransitionScan::progress() const {
  if (first_ >= clips_.size() || allCells_ == 0.0) return 1.0;
  return std::min(1.0, doneCells_ / allCells_);
}

void TransitionScan::beginPair() {
  const std::size_t columns = clips_[second_].windowCount();
  if (first_ == second_) {
    valleys_.emplace(ValleyFinder::ofOneClip(params_, columns));
    rows_.emplace(clips_[first_], valleys_->reach());
  } else {
    valleys_.emplace(params_, columns);
    rows_.emplace(clips_[first_], clips_[second_]);
  }
}

void TransitionScan::endPair() {
  const std::size_t last = params_.transitionFrames - 1;
  for (const Region& region : valleys_->finish()) {
    const std::size_t row = region.row + kWindowReach;
    const std::size_t column = region.column + kWindowReach;
    found_.push_back({{first_, row}, {second_, column + last}, region.meanDistanceMetres});
    found_.push_back({{second_, column}, {first_, row + last}, region.meanDistanceMetres});
  }
  rows_.reset();
  valleys_.reset();
  if (++second_ == clips_.size()) second_ = ++first_;
}

bool TransitionScan::step() {
  std::size_t work = 0;
  while (first_ < clips_.size() && work < kPairsInAStep) {
    if (!rows_) beginPair();
    const std::size_t count = rows_->advance();
    for (std::size_t k = 0; k < count; ++k) valleys_->addRow(rows_->row(k), rows_->firstColumn());
    const std::size_t columns = clips_[second_].windowCount();
    const std::size_t pairs = count * (columns - std::min(columns, rows_->firstColumn()));
    doneCells_ += static_cast<double>(count * columns);
    framePairs_ += pairs;
    // Even a pair of clips without any windows costs a little, so that a step stays short.
    work += pairs + 1000;
    if (count == 0) endPair();
  }
  return first_ < clips_.size();
}

std::vector<FoundTransition> TransitionScan::take() {
  std::sort(found_.begin(), found_.end(), [](const FoundTransition& a, const FoundTransition& b) {
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  });
  return std::move(found_);
}

}  // namespace stridegraph
