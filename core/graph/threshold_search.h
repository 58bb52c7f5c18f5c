#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "graph/frame_features.h"
#include "graph/jerks.h"
#include "graph/library.h"
#include "graph/transition_scan.h"

namespace stridegraph {

/// What a threshold is searched for.
struct ThresholdGoal {
  double fromMetres = 0.05;     ///< The smallest that is tried, > 0.
  double toMetres = 0.3;        ///< The largest that is tried: poses farther apart do not blend.
  std::size_t leastFrames = 1;  ///< So many frames are to be in the graph.
};

struct ThresholdFinding {
  double thresholdMetres = 0.0;  ///< The goal's `fromMetres`, or whole millimetres.
  std::size_t playedFrames = 0;  ///< In the graph that it gives.
};

/// Finds the smallest threshold, to a millimetre, with which the graph of some clips plays a number of
/// frames. It compares all pairs of frames under a threshold half as large again each time, until the graph
/// plays enough. The regions of a scan whose largest distance is at most some smaller tau are all found under
/// tau as well (Region::largestMicrometres), and more regions never take a walk away; so one scan tells of
/// every smaller threshold by bisection. The result is scanned once more, and then what lies a millimetre
/// below it: what is found has been tried.
///
/// The work is bounded: clips are taken in order until their pairs of frames reach kMostPairs, which may
/// leave a smaller threshold unseen but never gives a wrong one, and a scan ends at kMostRegions.
class ThresholdSearch {
 public:
  static constexpr double kMostPairs = 1e8;
  static constexpr std::size_t kMostRegions = 100'000;

  /// `library` has its params, clips and frames, needs no graph and stays longer than the search; jerks
  /// ascend; `features` are those of its clips, or of the first of them.
  ThresholdSearch(const MotionLibrary& library, std::span<const Jerk> jerks,
                  std::vector<ClipFeatures> features, const ThresholdGoal& goal);

  /// How many of the clips, from the first on, can be searched within kMostPairs.
  static std::size_t searchable(std::span<const LibraryClip> clips);

  /// Does a bounded piece of work. False when nothing is left to do.
  bool step();
  /// Share done, 0..1. It never falls.
  double progress() const;
  /// Empty until the end, and where no threshold up to the goal's largest will do.
  const std::optional<ThresholdFinding>& found() const { return found_; }
  /// Whether all regions of the clips given were seen, so that nothing found means that there is nothing.
  bool sawAll() const { return sawAll_; }

 private:
  void beginScan(double thresholdMetres);
  void endScan();
  void probe();
  void conclude();
  void tryAt(double thresholdMetres);
  double candidateMetres(std::size_t candidate) const;
  std::size_t playedWith(double thresholdMetres) const;

  const MotionLibrary& library_;
  std::span<const Jerk> jerks_;
  std::vector<ClipFeatures> features_;
  ThresholdGoal goal_;
  double scannedMetres_ = 0.0;  ///< Threshold of the scan at hand.
  std::optional<TransitionScan> scan_;
  std::vector<ScannedRegion> regions_;  ///< Of the last scan.
  /// Candidates below low_ will not do, those from end_ on are not asked any more.
  std::size_t low_ = 0;
  std::size_t end_ = 0;
  std::optional<ThresholdFinding> best_;  ///< Of the last scan.
  std::size_t rounds_ = 0;                ///< Scans done.
  std::size_t mostRounds_ = 1;
  std::size_t descents_ = 0;
  bool sawAll_ = true;
  bool isDone_ = false;
  std::optional<ThresholdFinding> found_;
};

}  // namespace stridegraph
