#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "graph/library.h"
#include "graph/similarity.h"
#include "graph/valleys.h"

namespace stridegraph {

/// What an earlier scan found, so that it need not be found again.
struct KnownRegions {
  std::vector<bool> clips;  ///< For each clip of the scan, whether it took part in that one unchanged;
  std::vector<AlikeRegion> regions;  ///< all regions of pairs of such clips, by frames of this scan.
};

/// A region, and the largest distance along it where ValleyParams::tellLargest asks for that.
struct ScannedRegion {
  AlikeRegion region;
  std::uint32_t largestMicrometres = 0;

  auto operator<=>(const ScannedRegion&) const = default;
};

/// Finds the regions where clips are alike among all pairs of them, bit by bit. Windows never cross the ends
/// of a clip; clips shorter than l + 4 frames have none. A pair's regions depend on its two clips alone.
class TransitionScan {
 public:
  /// `clips` as made by one featureBasis(); frames are counted through all of them. Pairs of known clips are
  /// not compared.
  TransitionScan(std::vector<ClipFeatures> clips, const ValleyParams& params, KnownRegions known = {});

  /// Compares some ten thousand pairs of frames. False when all is done.
  bool step();
  /// Share done, 0..1.
  double progress() const;
  /// Pairs of frames compared so far; each unordered pair counts once.
  std::size_t framePairs() const { return framePairs_; }
  /// Regions found or known so far.
  std::size_t regionCount() const { return found_.size() + (pairIsBegun_ ? valleys_.regionCount() : 0); }
  /// What was found or known, in ascending order; empties the scan.
  std::vector<AlikeRegion> take();
  /// The same with their largest distances. Known regions have none.
  std::vector<ScannedRegion> takeScanned();
  /// The clips, for another scan; empties this one.
  std::vector<ClipFeatures> takeClips() { return std::move(clips_); }

 private:
  bool isKnown(std::size_t clip) const { return clip < knownClips_.size() && knownClips_[clip]; }
  bool isKnownPair() const { return isKnown(first_) && isKnown(second_); }
  void beginPair();
  void endPair();
  void nextPair();

  std::vector<ClipFeatures> clips_;
  std::vector<bool> knownClips_;
  std::vector<std::size_t> starts_;  ///< First frame of each clip.
  std::size_t first_ = 0;            ///< The pair at hand: rows from the one clip,
  std::size_t second_ = 0;           ///< columns from the other, second_ >= first_.
  bool pairIsBegun_ = false;
  DistanceRows rows_;
  ValleyFinder valleys_;
  std::size_t framePairs_ = 0;
  double doneCells_ = 0.0;
  double allCells_ = 0.0;
  std::vector<ScannedRegion> found_;
};

}  // namespace stridegraph
