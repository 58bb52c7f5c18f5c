#include "walk/foot_cleanup.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/floor_transform.h"
#include "walk/correction_blend.h"
#include "walk/foot_roll.h"
#include "walk/footprints.h"
#include "walk/lean.h"

namespace stridegraph {
namespace {

constexpr double kBlendSeconds = 0.3;      ///< In which a correction fades.
constexpr double kRootSeconds = 0.6;       ///< Over which the root takes up what the feet need: a step or so.
constexpr double kLoweringSeconds = 0.15;  ///< In which the root is lowered and raised again.
constexpr double kLargestLowering = 0.04;  ///< Metres.
/// A leg may be stretched so far, or as far as the clip stretches it: beyond, the knee snaps.
constexpr double kUsualReach = 0.985;
/// Tips of feet that push off lie a little deeper than feet that stand.
constexpr double kLargestSink = 0.018;  // metres

std::size_t framesIn(double seconds, const Clip& clip) {
  return static_cast<std::size_t>(std::max(1.0, std::round(seconds * clip.framesPerSecond)));
}

double medianOf(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// A foot at work.
struct FootAtWork {
  const WalkFoot& foot;
  FootTrack track;
  std::vector<double> levels;  ///< For each of the foot's contacts.
  std::vector<PinnedStance> stances;
  std::vector<FootCorrection> corrections;
  std::vector<double> reach;  ///< Longest that the leg may be, frame by frame, metres.
};

/// Raises the foot where one of its joints lies too deep.
void liftSunken(std::size_t reachFrames, FootAtWork& foot) {
  std::vector<double> missing(foot.track.frameCount(), 0.0);
  for (std::size_t k = 0; k < foot.levels.size(); ++k) {
    if (std::isnan(foot.levels[k])) continue;
    for (std::size_t f = 0; f < missing.size(); ++f) {
      const double height = foot.track.points[k][f].y() + foot.corrections[f][1];
      missing[f] = std::max(missing[f], foot.levels[k] - kLargestSink - height);
    }
  }
  const std::vector<double> lift = smoothEnvelope(missing, reachFrames);
  for (std::size_t f = 0; f < lift.size(); ++f) foot.corrections[f][1] += lift[f];
}

/// What the foot needs in every frame when the root rises by so much.
void correct(std::span<const double> rootRises, const Clip& clip, FootAtWork& work) {
  std::vector<PinnedStance> stances = work.stances;
  for (PinnedStance& pinned : stances) rollOverToes(work.track, work.foot, rootRises, pinned);
  work.corrections = carryCorrections(stances, clip.frameCount(), framesIn(kBlendSeconds, clip));
  liftSunken(framesIn(0.5 * kLoweringSeconds, clip), work);
}

std::vector<double> reachOf(const FootAtWork& foot) {
  std::vector<double> reach;
  for (std::size_t f = 0; f < foot.track.frameCount(); ++f)
    reach.push_back(std::max(kUsualReach * foot.foot.legMetres,
                             (foot.track.ankles[f].position - foot.track.hips[f]).norm()));
  return reach;
}

/// How the root follows the feet up and down.
std::vector<double> rootShifts(const std::vector<FootAtWork>& feet, const Clip& clip) {
  std::vector<double> sums(clip.frameCount(), 0.0);
  std::vector<double> counts(clip.frameCount(), 0.0);
  for (const FootAtWork& foot : feet) {
    for (const PinnedStance& pinned : foot.stances) {
      for (std::size_t f = pinned.stance.first; f <= pinned.stance.last; ++f) {
        sums[f] += pinned.corrections.front()[1];
        counts[f] += 1.0;
      }
    }
  }
  for (std::size_t f = 0; f < sums.size(); ++f)
    if (counts[f] > 0.0) sums[f] /= counts[f];
  return smoothMean(sums, counts, framesIn(kRootSeconds, clip));
}

/// How far the root must come down so that every leg reaches its ankle's place.
std::vector<double> rootLowering(const std::vector<FootAtWork>& feet, const std::vector<double>& shifts,
                                 const Clip& clip) {
  std::vector<double> lowering(clip.frameCount(), 0.0);
  for (const FootAtWork& foot : feet) {
    for (std::size_t f = 0; f < lowering.size(); ++f) {
      const Vec3 ankle = foot.track.ankles[f].position + foot.corrections[f].head<3>();
      const Vec3 hip = foot.track.hips[f] + Vec3(0.0, shifts[f], 0.0);
      const double across = (onFloor(ankle) - onFloor(hip)).norm();
      const double up = std::sqrt(std::max(0.0, foot.reach[f] * foot.reach[f] - across * across));
      // Below a nanometre it is rounding, which must not touch frames that need nothing.
      const double missing = hip.y() - ankle.y() - up;
      if (missing > 1e-9) lowering[f] = std::max(lowering[f], std::min(missing, kLargestLowering));
    }
  }
  return smoothEnvelope(lowering, framesIn(kLoweringSeconds, clip));
}

/// Brings the foot where it should be under a root that has risen.
void solveFrame(const Skeleton& skeleton, const FootAtWork& foot, std::size_t frame, double rootRise,
                Clip& clip) {
  const FootCorrection& correction = foot.corrections[frame];
  const JointPlacement& ankle = foot.track.ankles[frame];
  AnkleTarget target{ankle.position + correction.head<3>(), ankle.rotation};
  if (correction[3] != 0.0) target.rotation = yawTurn(correction[3]) * target.rotation;
  if (correction[4] != 0.0)
    target.rotation = target.rotation * Quat(Eigen::AngleAxisd(correction[4], foot.foot.sideInAnkle));
  const double longestShare = foot.reach[frame] / foot.foot.legMetres;
  const JointPlacement hip{foot.track.hipRotations[frame], foot.track.hips[frame] + Vec3(0.0, rootRise, 0.0)};
  solveLeg(skeleton, foot.foot.leg, target, std::min(1.0, longestShare), hip, clip.rotationsOf(frame));
}

/// Leans the body, raises the root, and brings all feet where they should be.
void bringIntoPlace(const Skeleton& skeleton, const std::vector<FootAtWork>& feet,
                    std::span<const Lean> leans, std::span<const double> rises, Clip& clip) {
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    const bool stays = leans[f].isUpright() && rises[f] == 0.0;
    for (const FootAtWork& foot : feet) {
      if (!stays || foot.corrections[f] != FootCorrection::Zero())
        solveFrame(skeleton, foot, f, rises[f], clip);
    }
    if (stays) continue;
    clip.rootPositions[f].y() += rises[f];
    if (leans[f].isUpright()) continue;
    Quat& root = clip.rotationsOf(f)[0];
    root = (leans[f].turn * root).normalized();
  }
}

FootCleanupReport reportOf(const std::vector<FootAtWork>& feet) {
  FootCleanupReport report;
  std::size_t frames = 0;
  for (const FootAtWork& foot : feet) {
    report.stances += foot.stances.size();
    for (const PinnedStance& pinned : foot.stances) {
      for (std::size_t f = pinned.stance.first; f <= pinned.stance.last; ++f, ++frames) {
        const double moved = foot.corrections[f].head<3>().norm();
        report.meanCorrectionMetres += moved;
        report.worstCorrectionMetres = std::max(report.worstCorrectionMetres, moved);
      }
    }
  }
  if (frames > 0) report.meanCorrectionMetres /= static_cast<double>(frames);
  return report;
}

}  // namespace

FootCleanup::FootCleanup(const MotionLibrary& library)
    : feet_(findWalkFeet(library)),
      levelsMetres_(library.contactJoints.size(), std::numeric_limits<double>::quiet_NaN()) {
  for (const WalkFoot& foot : feet_.feet) {
    const FootTrack track = trackFoot(library, foot, library.frames, library.contacts);
    std::vector<std::vector<double>> heights(foot.contacts.size());
    for (const FootStance& stance : findStances(track)) {
      const std::vector<double> standing = standingHeights(track, stance);
      for (std::size_t k = 0; k < standing.size(); ++k)
        if (!std::isnan(standing[k])) heights[k].push_back(standing[k]);
    }
    for (std::size_t k = 0; k < heights.size(); ++k) levelsMetres_[foot.contacts[k]] = medianOf(heights[k]);
  }
}

FootCleanupReport FootCleanup::apply(const MotionLibrary& library, SynthesisedWalk& walk) const {
  Clip& clip = walk.clip;
  const std::vector<Lean> leans =
      balancingLeans(walk.accelerations, clip.rootPositions, clip.framesPerSecond);
  std::vector<FootAtWork> feet;
  for (const WalkFoot& foot : feet_.feet) {
    FootAtWork& work =
        feet.emplace_back(FootAtWork{foot, trackFoot(library, foot, clip, walk.contacts), {}, {}, {}, {}});
    for (const std::size_t k : foot.contacts) work.levels.push_back(levelsMetres_[k]);
    work.reach = reachOf(work);
    leanOver(leans, clip.rootPositions, work.track);
    work.stances = pinStances(work.track, work.levels);
  }
  std::vector<double> rises = rootShifts(feet, clip);
  for (std::size_t f = 0; f < rises.size(); ++f) rises[f] -= leans[f].rootSinks;
  for (FootAtWork& work : feet) correct(rises, clip, work);
  const std::vector<double> lowering = rootLowering(feet, rises, clip);
  for (std::size_t f = 0; f < rises.size(); ++f) rises[f] -= lowering[f];
  for (FootAtWork& work : feet) correct(rises, clip, work);
  bringIntoPlace(library.skeleton, feet, leans, rises, clip);
  FootCleanupReport report = reportOf(feet);
  report.feetLeftAlone = feet_.withoutLeg;
  report.worstLoweringMetres = lowering.empty() ? 0.0 : *std::max_element(lowering.begin(), lowering.end());
  return report;
}

}  // namespace stridegraph
