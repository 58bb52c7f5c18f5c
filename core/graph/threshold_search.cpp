#include "graph/threshold_search.h"

#include <algorithm>
#include <cmath>

#include "graph/library_connection.h"
#include "graph/pose_distance.h"
#include "graph/survival.h"

namespace stridegraph {
namespace {

constexpr double kGrowth = 1.5;
/// The first threshold tried is at least this, metres: much smaller ones hardly tell.
constexpr double kLeastScannedMetres = 0.03;
constexpr double kCandidatesPerMetre = 1000.0;
/// Scans a millimetre below a result that has been tried.
constexpr std::size_t kMostDescents = 8;
/// Scans that try a result and what lies below it, which may give others to try.
constexpr std::size_t kConfirmingRounds = 2 * kMostDescents;

ValleyParams valleyParams(const LibraryParams& params, double thresholdMetres) {
  return {.thresholdMetres = thresholdMetres,
          .transitionFrames = params.transitionFrames,
          .neighbourFrames = params.neighbourFrames,
          .largestSpanRatio = params.largestSpanRatio,
          .tellLargest = true};
}

double windowsOf(const LibraryClip& clip) {
  return static_cast<double>(clip.frameCount) - 2.0 * static_cast<double>(kWindowReach);
}

}  // namespace

ThresholdSearch::ThresholdSearch(const MotionLibrary& library, std::span<const Jerk> jerks,
                                 std::vector<ClipFeatures> features, const ThresholdGoal& goal)
    : library_(library), jerks_(jerks), features_(std::move(features)), goal_(goal) {
  isDone_ = features_.empty() || goal_.fromMetres >= goal_.toMetres;
  if (isDone_) return;
  const double first = std::min(goal_.toMetres, std::max(kGrowth * goal_.fromMetres, kLeastScannedMetres));
  mostRounds_ = kConfirmingRounds + 1 +
                static_cast<std::size_t>(std::ceil(std::log(goal_.toMetres / first) / std::log(kGrowth)));
  beginScan(first);
}

std::size_t ThresholdSearch::searchable(std::span<const LibraryClip> clips) {
  double windows = 0.0;
  std::size_t count = 0;
  for (const LibraryClip& clip : clips) {
    windows += std::max(0.0, windowsOf(clip));
    if (0.5 * windows * windows > kMostPairs) break;
    ++count;
  }
  return count;
}

void ThresholdSearch::beginScan(double thresholdMetres) {
  scannedMetres_ = thresholdMetres;
  scan_.emplace(std::move(features_), valleyParams(library_.params, thresholdMetres));
}

bool ThresholdSearch::step() {
  if (isDone_) return false;
  if (!scan_) {
    probe();
  } else if (!scan_->step() || scan_->regionCount() > kMostRegions) {
    endScan();
  }
  return !isDone_;
}

double ThresholdSearch::progress() const {
  if (isDone_) return 1.0;
  const double ofScan = scan_ ? scan_->progress() : 1.0;
  return std::min(1.0, (static_cast<double>(rounds_) + ofScan) / static_cast<double>(mostRounds_));
}

/// Candidate 0 is where the search starts from, the others are the whole millimetres above.
double ThresholdSearch::candidateMetres(std::size_t candidate) const {
  if (candidate == 0) return goal_.fromMetres;
  return (std::floor(goal_.fromMetres * kCandidatesPerMetre) + static_cast<double>(candidate)) /
         kCandidatesPerMetre;
}

std::size_t ThresholdSearch::playedWith(double thresholdMetres) const {
  const std::uint32_t limit = ValleyFinder::limitMicrometres(thresholdMetres);
  std::vector<AlikeRegion> regions;
  for (const ScannedRegion& scanned : regions_) {
    if (scanned.largestMicrometres <= limit) regions.push_back(scanned.region);
  }
  return playedFrames(library_, connectionOf(library_, jerks_, regions).pruned);
}

void ThresholdSearch::endScan() {
  regions_ = scan_->takeScanned();
  features_ = scan_->takeClips();
  scan_.reset();
  best_.reset();
  low_ = 0;
  end_ = 0;
  while (candidateMetres(end_) <= scannedMetres_) ++end_;
}

void ThresholdSearch::probe() {
  if (low_ == end_) return conclude();
  const std::size_t middle = low_ + (end_ - low_) / 2;
  const double metres = candidateMetres(middle);
  const std::size_t played = playedWith(metres);
  if (played < goal_.leastFrames) {
    low_ = middle + 1;
    return;
  }
  best_ = ThresholdFinding{metres, played};
  end_ = middle;
}

void ThresholdSearch::conclude() {
  ++rounds_;
  const bool isCut = regions_.size() > kMostRegions;
  if (isCut) sawAll_ = false;
  if (best_) {
    found_ = best_;
    if (best_->thresholdMetres < scannedMetres_) return tryAt(best_->thresholdMetres);
    // Under a smaller threshold fewer lines compete, and some that were passed over may do.
    if (low_ > 0 && descents_++ < kMostDescents) return tryAt(candidateMetres(low_ - 1));
    isDone_ = true;
  } else if (found_) {
    // Also where with more regions another part of the graph is the largest, and plays fewer frames.
    if (scannedMetres_ == found_->thresholdMetres && !isCut)
      found_->playedFrames = playedWith(scannedMetres_);
    isDone_ = true;
  } else {
    isDone_ = isCut || scannedMetres_ >= goal_.toMetres;
    if (!isDone_) beginScan(std::min(goal_.toMetres, kGrowth * scannedMetres_));
  }
}

void ThresholdSearch::tryAt(double thresholdMetres) {
  isDone_ = rounds_ >= mostRounds_;
  if (!isDone_) beginScan(thresholdMetres);
}

}  // namespace stridegraph
