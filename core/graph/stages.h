#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace stridegraph {

/// One stage of long work that is done in pieces.
template <typename Owner>
struct Stage {
  double weight = 0.0;  ///< About which share of the whole it takes; the weights of all stages sum to 1.
  /// Does a bounded piece of work. Returns which share of the stage is done, 1 at its end.
  double (Owner::*step)() = nullptr;
};

/// How far long work has come in a row of stages.
template <typename Owner>
class StageRow {
 public:
  explicit StageRow(std::span<const Stage<Owner>> stages) : stages_(stages) {}

  /// Does the next piece of work. False when nothing is left to do.
  bool step(Owner& owner) {
    if (isDone()) return false;
    const double share = (owner.*stages_[stage_].step)();
    // The piece itself may have ended the work.
    if (isDone()) return false;
    share_ = std::clamp(share, share_, 1.0);
    if (share_ < 1.0) return true;
    before_ += stages_[stage_].weight;
    share_ = 0.0;
    ++stage_;
    return !isDone();
  }
  /// Leaves out all that follows.
  void end() { stage_ = stages_.size(); }
  bool isDone() const { return stage_ == stages_.size(); }
  /// Share of the whole that is done, 0..1. It never falls.
  double progress() const {
    if (isDone()) return 1.0;
    return std::min(1.0, before_ + stages_[stage_].weight * share_);
  }

 private:
  std::span<const Stage<Owner>> stages_;
  std::size_t stage_ = 0;
  double share_ = 0.0;   ///< Of the stage at hand.
  double before_ = 0.0;  ///< Weights of the stages done.
};

}  // namespace stridegraph
