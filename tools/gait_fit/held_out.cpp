#include "gait_fit/held_out.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gait_fit/lean.h"
#include "gait_fit/table.h"
#include "math/rotation.h"
#include "motion/kinematics.h"

namespace stridegraph::gait_fit {
namespace {

using Eigen::Index;

constexpr double kDegrees = 180.0 / std::numbers::pi;
/// A clip is straight when its whole path bends by less than this, and steady when its speed's standard
/// deviation is below this share.
constexpr double kStraightTurn = 15.0 / kDegrees;
constexpr double kSteadyShare = 0.1;

/// Squares summed over frames.
struct ErrorSums {
  std::array<double, kStoredJointCount> joints{};
  Vec3 root = Vec3::Zero();
  double frames = 0.0;

  static double sidesOf(std::size_t joint) {
    const GaitJoint stored = gaitJointOf(static_cast<StoredJoint>(joint));
    return otherSide(stored) == stored ? 1.0 : 2.0;
  }
  void add(const Pose& captured, const Pose& model) {
    for (std::size_t j = 0; j < kStoredJointCount; ++j) {
      const GaitJoint left = gaitJointOf(static_cast<StoredJoint>(j));
      joints[j] += squareAt(captured, model, left);
      if (otherSide(left) != left) joints[j] += squareAt(captured, model, otherSide(left));
    }
    root += (captured.rootPosition - model.rootPosition).cwiseAbs2();
    frames += 1.0;
  }
  void add(const ErrorSums& other) {
    for (std::size_t j = 0; j < kStoredJointCount; ++j) joints[j] += other.joints[j];
    root += other.root;
    frames += other.frames;
  }
  PoseErrors errors() const {
    PoseErrors errors;
    double all = 0.0;
    double slots = 0.0;
    for (std::size_t j = 0; j < kStoredJointCount; ++j) {
      errors.joints[j] = kDegrees * std::sqrt(joints[j] / (sidesOf(j) * frames));
      all += joints[j];
      slots += sidesOf(j);
    }
    errors.allJoints = kDegrees * std::sqrt(all / (slots * frames));
    const double pelvis = joints[static_cast<std::size_t>(StoredJoint::kPelvis)];
    errors.withoutPelvis = kDegrees * std::sqrt((all - pelvis) / ((slots - 1.0) * frames));
    errors.rootCentimetres = 100.0 * (root / frames).cwiseSqrt();
    return errors;
  }

 private:
  static double squareAt(const Pose& a, const Pose& b, GaitJoint joint) {
    const double angle = angleBetween(a.rotations[indexOf(joint)], b.rotations[indexOf(joint)]).radians();
    return angle * angle;
  }
};

/// What is summed over the clips of a gait.
struct Sums {
  ErrorSums poses;
  std::vector<LeanSample> leans;
};

double meanGoing(const Track& track, const Eigen::VectorXd& values) {
  return values.dot(track.going) / std::max(1.0, track.going.sum());
}

bool isStraightAndSteady(const Track& track) {
  const double mean = meanGoing(track, track.speed);
  const Eigen::VectorXd apart = (track.speed.array() - mean).square();
  return track.going.minCoeff() > 0.0 &&
         track.heading.maxCoeff() - track.heading.minCoeff() < kStraightTurn &&
         std::sqrt(meanGoing(track, apart)) < kSteadyShare * mean;
}

/// Mean distance of points of the captured body from the straight gait of the clip's mean speed.
double straightCentimetres(const Track& track, const GaitTable& table) {
  const double speed = meanGoing(track, track.speed);
  double sum = 0.0;
  for (Index f = 0; f < track.frames(); ++f) {
    Pose captured = poseOnPath(track, f);
    Pose model = gaitPose(table, {track.phase[f], speed});
    captured.rootPosition = model.rootPosition = Vec3::Zero();
    const auto a = jointPositions(gaitSkeleton(), captured.view());
    const auto b = jointPositions(gaitSkeleton(), model.view());
    for (std::size_t j = 0; j < a.size(); ++j) sum += (a[j] - b[j]).norm();
  }
  return 100.0 * sum / static_cast<double>(track.frames()) / static_cast<double>(kGaitJointCount);
}

/// Adds the frames of one clip, its phase already fitted to `table`; returns those of the clip alone.
ErrorSums addClip(const Track& track, const GaitTable& table, Sums& sums) {
  ErrorSums ofClip;
  for (Index f = 0; f < track.frames(); ++f) {
    if (track.going[f] <= 0.0) continue;
    const Pose captured = poseOnPath(track, f);
    const Pose model = gaitPose(table, track.state(f));
    ofClip.add(captured, model);
  }
  sums.poses.add(ofClip);
  const std::vector<LeanSample> leans = leanSamples(track, table);
  sums.leans.insert(sums.leans.end(), leans.begin(), leans.end());
  return ofClip;
}

ClipErrors errorsOf(const Track& track, const GaitTable& table, const ErrorSums& ofClip) {
  ClipErrors errors{track.clip.name, meanGoing(track, track.speed), ofClip.errors().allJoints, {}};
  if (isStraightAndSteady(track)) errors.straightCentimetres = straightCentimetres(track, table);
  return errors;
}

/// Mean and worst of the straight clips.
void sumUpStraight(HeldOutFigures& figures) {
  double clips = 0.0;
  for (const ClipErrors& clip : figures.clips) {
    if (!clip.straightCentimetres) continue;
    clips += 1.0;
    figures.straightMeanCentimetres += *clip.straightCentimetres;
    figures.straightWorstCentimetres = std::max(figures.straightWorstCentimetres, *clip.straightCentimetres);
  }
  figures.straightMeanCentimetres /= std::max(1.0, clips);
}

}  // namespace

Result<HeldOutFigures> measureHeldOut(const GaitFit& fit) {
  if (fit.tracks.size() < 2)
    return fail(ErrorCode::kInvalidArgument, "found one clip, expected at least two to leave one out");
  std::vector<NormalEquations> equations;
  for (std::size_t t = 0; t < fit.tracks.size(); ++t)
    equations.push_back(equationsOf(fit.params.series.referenceSpeed, fit.tracks[t], fit.channels[t]));
  auto whole = tableOf(fit.series, {}, 1.0);
  if (!whole) return fail(std::move(whole));
  HeldOutFigures figures;
  Sums trained;
  Sums heldOut;
  for (std::size_t t = 0; t < fit.tracks.size(); ++t) {
    Track track = fit.tracks[t];
    addClip(track, *whole, trained);
    const Series others = solveWithout(fit, equations, t);
    constexpr int kRounds = 3;
    for (int round = 0; round < kRounds; ++round)
      refinePhase(fit.params.phase, others, fit.channels[t], track);
    auto table = tableOf(others, {}, 1.0);
    if (!table) return fail(std::move(table));
    figures.clips.push_back(errorsOf(track, *table, addClip(track, *table, heldOut)));
  }
  figures.trained = trained.poses.errors();
  figures.heldOut = heldOut.poses.errors();
  const LeanSlopes slopes = leanSlopes(heldOut.leans);
  figures.lean = {slopes.captured, slopes.model, leanSlopes(trained.leans).model};
  sumUpStraight(figures);
  return figures;
}

}  // namespace stridegraph::gait_fit
