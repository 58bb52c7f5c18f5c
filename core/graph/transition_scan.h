#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "graph/similarity.h"
#include "graph/valleys.h"

namespace stridegraph {

/// A frame of one of several clips.
struct ClipFrame {
  std::size_t clip = 0;
  std::size_t frame = 0;
  auto operator<=>(const ClipFrame&) const = default;
};

/// A way from one clip into another (or the same): a blend that begins on frame `from` and ends on frame
/// `to`, over l - 1 steps in both clips.
struct FoundTransition {
  ClipFrame from;
  ClipFrame to;
  double meanDistanceMetres = 0.0;
};

/// Finds the transitions between all pairs of clips, bit by bit. A region of two clips is used in both
/// directions. Windows never cross the ends of a clip; clips shorter than l + 4 frames have none.
class TransitionScan {
 public:
  /// `clips` as made by one featureBasis().
  TransitionScan(std::vector<ClipFeatures> clips, const ValleyParams& params);

  /// Compares some ten thousand pairs of frames. False when all is done.
  bool step();
  /// Share done, 0..1.
  double progress() const;
  /// Pairs of frames compared so far; each unordered pair counts once.
  std::size_t framePairs() const { return framePairs_; }
  /// What was found, by (from, to); empties the scan.
  std::vector<FoundTransition> take();

 private:
  void beginPair();
  void endPair();

  std::vector<ClipFeatures> clips_;
  ValleyParams params_;
  std::size_t first_ = 0;   ///< The pair at hand: rows from the one clip,
  std::size_t second_ = 0;  ///< columns from the other, second_ >= first_.
  std::optional<DistanceRows> rows_;
  std::optional<ValleyFinder> valleys_;
  std::size_t framePairs_ = 0;
  double doneCells_ = 0.0;
  double allCells_ = 0.0;
  std::vector<FoundTransition> found_;
};

}  // namespace stridegraph
