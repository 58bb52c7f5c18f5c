#include "graph/build_trials.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stridegraph {
namespace {

double shareOf(std::size_t done, std::size_t all) {
  return done >= all ? 1.0 : static_cast<double>(done) / static_cast<double>(all);
}

}  // namespace

std::span<const Stage<BuildTrials>> BuildTrials::stages() {
  static constexpr std::array<Stage<BuildTrials>, 6> kStages = {{{0.02, &BuildTrials::featuresOfOne},
                                                                 {0.30, &BuildTrials::searchOn},
                                                                 {0.02, &BuildTrials::mirrorOne},
                                                                 {0.02, &BuildTrials::mirrorJerksOfOne},
                                                                 {0.04, &BuildTrials::mirrorFeaturesOfOne},
                                                                 {0.60, &BuildTrials::searchMirrored}}};
  return kStages;
}

BuildTrials::BuildTrials(ClipIntake& intake, const MotionLibrary& library, const std::vector<Jerk>& jerks,
                         const Params& params)
    : intake_(intake), library_(library), jerks_(jerks), params_(params), stages_(stages()) {}

std::size_t BuildTrials::leastFramesOf(const MotionLibrary& library) const {
  const double frames = params_.leastShare * static_cast<double>(library.frames.frameCount());
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(frames)));
}

double BuildTrials::addFeatures(const MotionLibrary& library) {
  const std::size_t count = ThresholdSearch::searchable(library.clips);
  if (count == 0) return 1.0;
  if (features_.empty()) basis_ = featureBasis(library.skeleton, intake_.clips());
  features_.emplace_back(library.skeleton, basis_, intake_.clips()[features_.size()]);
  return shareOf(features_.size(), count);
}

double BuildTrials::featuresOfOne() {
  return addFeatures(library_);
}

double BuildTrials::searchOn() {
  if (!search_) {
    if (features_.empty()) {
      stages_.end();
      return 1.0;
    }
    ThresholdGoal goal;
    goal.fromMetres = library_.params.thresholdMetres;
    goal.leastFrames = leastFramesOf(library_);
    if (features_.size() == library_.clips.size()) findings_.largestTriedMetres = goal.toMetres;
    search_.emplace(library_, jerks_, std::move(features_), goal);
  }
  if (search_->step()) return search_->progress();
  findings_.asTheyAre = search_->found();
  if (!search_->sawAll()) findings_.largestTriedMetres = 0.0;
  search_.reset();
  features_.clear();
  if (!params_.triesMirror || !intake_.findMirror()) stages_.end();
  return 1.0;
}

double BuildTrials::mirrorOne() {
  intake_.addMirrorOf(next_);
  if (++next_ < intake_.originals()) return shareOf(next_, intake_.originals());
  next_ = 0;
  mirrored_.skeleton = library_.skeleton;
  mirrored_.params = library_.params;
  mirrored_.params.mirror = true;
  intake_.collect(mirrored_);
  findings_.mirroredFrames = mirrored_.frames.frameCount();
  return 1.0;
}

double BuildTrials::mirrorJerksOfOne() {
  const std::vector<Jerk> found = findJerks(mirrored_, JointIndex(next_));
  mirroredJerks_.insert(mirroredJerks_.end(), found.begin(), found.end());
  if (++next_ < mirrored_.skeleton.size()) return shareOf(next_, mirrored_.skeleton.size());
  mirroredJerks_ = farthestByFrame(std::move(mirroredJerks_));
  return 1.0;
}

double BuildTrials::mirrorFeaturesOfOne() {
  return addFeatures(mirrored_);
}

double BuildTrials::searchMirrored() {
  if (!search_) {
    ThresholdGoal goal;
    goal.fromMetres = library_.params.thresholdMetres;
    if (findings_.asTheyAre) goal.toMetres = findings_.asTheyAre->thresholdMetres;
    goal.leastFrames = leastFramesOf(mirrored_);
    search_.emplace(mirrored_, mirroredJerks_, std::move(features_), goal);
  }
  if (search_->step()) return search_->progress();
  const std::optional<ThresholdFinding>& found = search_->found();
  const bool isBetter =
      found && (!findings_.asTheyAre || found->thresholdMetres < findings_.asTheyAre->thresholdMetres);
  if (isBetter) findings_.mirrored = found;
  return 1.0;
}

}  // namespace stridegraph
