#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "graph/clip_intake.h"
#include "graph/jerks.h"
#include "graph/library.h"
#include "graph/stages.h"
#include "graph/threshold_search.h"

namespace stridegraph {

/// What made a graph of clips that made none, or one that holds next to nothing.
struct TrialFindings {
  std::optional<ThresholdFinding> asTheyAre;
  /// With the mirror images of the clips. Only where it takes a smaller threshold.
  std::optional<ThresholdFinding> mirrored;
  std::size_t mirroredFrames = 0;  ///< Of clips and mirror images together.
  /// The largest threshold tried on all of the clips; 0 where there are too many frames to try them all.
  double largestTriedMetres = 0.0;
};

/// Tries larger thresholds on the clips of a library, and then mirror images, step by step.
class BuildTrials {
 public:
  struct Params {
    double leastShare = 0.0;   ///< Of the frames are to be in the graph; 0: any are enough.
    bool triesMirror = false;  ///< Adds mirror images to the intake, which then is of no further use.
  };

  /// `library` has its params, clips and frames; it, its jerks (ascending) and the intake stay longer than
  /// the trials.
  BuildTrials(ClipIntake& intake, const MotionLibrary& library, const std::vector<Jerk>& jerks,
              const Params& params);

  /// Does a bounded piece of work. False when nothing is left to do.
  bool step() { return stages_.step(*this); }
  /// Share done, 0..1. It never falls.
  double progress() const { return stages_.progress(); }
  const TrialFindings& findings() const { return findings_; }

 private:
  static std::span<const Stage<BuildTrials>> stages();
  double featuresOfOne();
  double searchOn();
  double mirrorOne();
  double mirrorJerksOfOne();
  double mirrorFeaturesOfOne();
  double searchMirrored();
  double addFeatures(const MotionLibrary& library);
  std::size_t leastFramesOf(const MotionLibrary& library) const;

  ClipIntake& intake_;
  const MotionLibrary& library_;
  const std::vector<Jerk>& jerks_;
  Params params_;
  MotionLibrary mirrored_;
  std::vector<Jerk> mirroredJerks_;
  std::vector<ClipFeatures> features_;
  FeatureBasis basis_;
  std::optional<ThresholdSearch> search_;
  std::size_t next_ = 0;
  TrialFindings findings_;
  StageRow<BuildTrials> stages_;
};

}  // namespace stridegraph
