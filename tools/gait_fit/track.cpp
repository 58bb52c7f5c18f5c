#include "gait_fit/track.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "gait_fit/spline.h"
#include "math/rotation.h"
#include "motion/leg_ik.h"

namespace stridegraph::gait_fit {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Fewest strides a second from which the rate of a first phase is improved.
constexpr double kFirstCadence = 2.0 * std::numbers::pi;

/// Columns cos, sin of each harmonic in the going frames.
MatrixXd oscillation(const Track& track, int harmonics) {
  if (track.phase.size() == 0) return MatrixXd(track.frames(), 0);
  MatrixXd columns(track.frames(), 2 * harmonics);
  for (int k = 1; k <= harmonics; ++k) {
    columns.col(2 * k - 2) = (k * track.phase).array().cos() * track.going.array();
    columns.col(2 * k - 1) = (k * track.phase).array().sin() * track.going.array();
  }
  return columns;
}

/// Coefficients of spline and oscillation in the least-squares sense; `penalty` holds the squared weights.
VectorXd leastSquares(const MatrixXd& design, const MatrixXd& penalty, const VectorXd& values) {
  return (design.transpose() * design + penalty).ldlt().solve(design.transpose() * values);
}

void splitHeading(const SplitParams& params, const Spline& spline, const MatrixXd& waves, Track& track) {
  VectorXd root(track.frames());
  for (Index f = 0; f < track.frames(); ++f)
    root[f] =
        separateHeading(track.clip.pose(static_cast<std::size_t>(f)).rotations[0]).heading.angle().radians();
  const Index smooth = spline.values.cols();
  MatrixXd design(track.frames(), smooth + waves.cols());
  design << spline.values, waves;
  MatrixXd penalty = MatrixXd::Identity(design.cols(), design.cols()) * params.oscillationRidge;
  penalty.topLeftCorner(smooth, smooth) =
      params.thirdDifference * spline.thirdDifferences.transpose() * spline.thirdDifferences;
  const VectorXd found = leastSquares(design, penalty, unwrapped(root));
  track.heading = spline.values * found.head(smooth);
  track.turnRate = spline.slopes * found.head(smooth);
}

/// Solves x = path_x + lateral cos + forward sin, z = path_z - lateral sin + forward cos together.
void splitPlace(const SplitParams& params, const Spline& spline, const MatrixXd& waves, Track& track) {
  const Index n = track.frames();
  const Index smooth = spline.values.cols();
  const Index w = waves.cols();
  const VectorXd sine = track.heading.array().sin();
  const VectorXd cosine = track.heading.array().cos();
  MatrixXd design = MatrixXd::Zero(2 * n, 2 * smooth + 2 * w);
  design.topLeftCorner(n, smooth) = spline.values;
  design.block(n, smooth, n, smooth) = spline.values;
  design.block(0, 2 * smooth, n, w) = cosine.asDiagonal() * waves;
  design.block(n, 2 * smooth, n, w) = -(sine.asDiagonal() * waves);
  design.block(0, 2 * smooth + w, n, w) = sine.asDiagonal() * waves;
  design.block(n, 2 * smooth + w, n, w) = cosine.asDiagonal() * waves;
  MatrixXd penalty = MatrixXd::Identity(design.cols(), design.cols()) * params.oscillationRidge;
  const MatrixXd smoothness =
      params.thirdDifference * spline.thirdDifferences.transpose() * spline.thirdDifferences;
  penalty.topLeftCorner(smooth, smooth) = smoothness;
  penalty.block(smooth, smooth, smooth, smooth) = smoothness;
  VectorXd place(2 * n);
  for (Index f = 0; f < n; ++f) {
    place[f] = track.clip.rootPositions[static_cast<std::size_t>(f)].x();
    place[n + f] = track.clip.rootPositions[static_cast<std::size_t>(f)].z();
  }
  const VectorXd found = leastSquares(design, penalty, place);
  const VectorXd velocityX = spline.slopes * found.head(smooth);
  const VectorXd velocityZ = spline.slopes * found.segment(smooth, smooth);
  track.path.resize(n, 2);
  track.path.col(0) = spline.values * found.head(smooth);
  track.path.col(1) = spline.values * found.segment(smooth, smooth);
  track.speed = (velocityX.array().square() + velocityZ.array().square()).sqrt();
  track.slip.resize(n);
  for (Index f = 0; f < n; ++f)
    track.slip[f] =
        std::remainder(std::atan2(velocityX[f], velocityZ[f]) - track.heading[f], 2.0 * std::numbers::pi);
}

}  // namespace

void splitRoot(const SplitParams& params, Track& track) {
  const double fps = track.clip.framesPerSecond;
  const Spline spline = cubicSpline(track.frames(), params.knotFrames, fps);
  const MatrixXd waves = oscillation(track, params.harmonics);
  splitHeading(params, spline, waves, track);
  splitPlace(params, spline, waves, track);
  track.speed = smoothed(track.speed, params.rateReach);
  track.turnRate = smoothed(track.turnRate, params.rateReach);
  track.acceleration = slopeOf(track.speed, fps);
  track.turnAcceleration = slopeOf(track.turnRate, fps);
}

VectorXd ankleSeparation(const Track& track) {
  const Skeleton skeleton = gaitSkeleton();
  VectorXd ahead(track.frames());
  for (Index f = 0; f < track.frames(); ++f) {
    const PoseView pose = track.clip.pose(static_cast<std::size_t>(f));
    const Vec3 apart = placeJoint(skeleton, pose, gaitLeg(Side::kLeft).ankle).position -
                       placeJoint(skeleton, pose, gaitLeg(Side::kRight).ankle).position;
    ahead[f] = apart.x() * std::sin(track.heading[f]) + apart.z() * std::cos(track.heading[f]);
  }
  return ahead;
}

void estimatePhase(double minimumSpeed, Track& track) {
  const double fps = track.clip.framesPerSecond;
  track.going = (track.speed.array() > minimumSpeed).cast<double>();
  const VectorXd ahead = smoothed(ankleSeparation(track), 3);
  const VectorXd rate = slopeOf(smoothed(ahead, 2), fps);
  double cadence = kFirstCadence;
  constexpr int kRounds = 4;
  for (int round = 0; round < kRounds; ++round) {
    VectorXd angle(track.frames());
    for (Index f = 0; f < track.frames(); ++f) angle[f] = std::atan2(-rate[f] / cadence, ahead[f]);
    track.phase = unwrapped(angle);
    const VectorXd slopes = slopeOf(track.phase, fps);
    std::vector<double> found;
    for (Index f = 0; f < track.frames(); ++f)
      if (track.going[f] > 0.0) found.push_back(slopes[f]);
    if (found.empty()) return;
    const auto middle = found.begin() + static_cast<std::ptrdiff_t>(found.size() / 2);
    std::nth_element(found.begin(), middle, found.end());
    if (*middle > 0.5) cadence = *middle;
  }
}

}  // namespace stridegraph::gait_fit
