#include "gait_fit/series.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace stridegraph::gait_fit {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

constexpr auto kTerms = static_cast<Index>(kGaitTermCount);
constexpr auto kRegressors = static_cast<Index>(kGaitRegressorCount);

/// How large each regressor gets in turns and changes of speed, in its own unit: 1, u, w, w^2, w', u', w w',
/// u w, u^2. The first four are penalised by `ridge`, the others, which few frames tell of, by `rateRidge`.
constexpr std::array<double, kGaitRegressorCount> kTypicalSizes = {1, 1, 1, 1, 3.3, 2, 3.3, 0.5, 0.5};
constexpr Index kWellKnown = 4;

using Terms = std::array<double, kGaitTermCount>;

/// Regressors times terms, in the order of the coefficients.
RowVectorXd features(double referenceSpeed, const GaitState& state, const Terms& terms) {
  const auto regressors = gaitRegressors(referenceSpeed, state);
  RowVectorXd row(kRegressors * kTerms);
  for (Index r = 0; r < kRegressors; ++r)
    for (Index t = 0; t < kTerms; ++t)
      row[r * kTerms + t] = regressors[static_cast<std::size_t>(r)] * terms[static_cast<std::size_t>(t)];
  return row;
}

/// The terms' derivatives by the phase.
Terms slopesOf(const Terms& terms) {
  Terms slopes{};
  for (std::size_t k = 1; k <= kGaitHarmonics; ++k) {
    slopes[2 * k - 1] = -static_cast<double>(k) * terms[2 * k];
    slopes[2 * k] = static_cast<double>(k) * terms[2 * k - 1];
  }
  return slopes;
}

/// Going frames away from the clip's ends, where splines invent turn rates.
VectorXd fitWeights(const Track& track) {
  VectorXd weights = track.going;
  weights.head(kEndFrames).setZero();
  weights.tail(kEndFrames).setZero();
  return weights;
}

/// What one channel counts in the phase: middle joints are seen twice, from both sides.
VectorXd channelWeights(const PhaseParams& params) {
  VectorXd weights = VectorXd::Ones(kChannelCount);
  constexpr Index kMiddleChannels = 3 * (static_cast<Index>(StoredJoint::kHead) + 1);
  weights.head(kMiddleChannels).setConstant(0.5);
  weights.tail(3).setConstant(0.5 * params.offsetWeight);
  return weights;
}

/// Adds stiffness * |second differences|^2 to the quadratic form.
MatrixXd secondDifferencePenalty(Index frames, double stiffness) {
  MatrixXd penalty = MatrixXd::Zero(frames, frames);
  Eigen::Matrix3d block;
  block << 1, -2, 1, -2, 4, -2, 1, -2, 1;
  for (Index f = 0; f + 2 < frames; ++f) penalty.block<3, 3>(f, f) += stiffness * block;
  return penalty;
}

}  // namespace

RowVectorXd Series::channelsAt(const GaitState& state) const {
  return features(referenceSpeed, state, gaitHarmonics(state.phase)) * coefficients;
}

RowVectorXd Series::phaseSlopesAt(const GaitState& state) const {
  return features(referenceSpeed, state, slopesOf(gaitHarmonics(state.phase))) * coefficients;
}

NormalEquations& NormalEquations::operator+=(const NormalEquations& other) {
  if (gram.size() == 0) return *this = other;
  gram += other.gram;
  moments += other.moments;
  offsetGram += other.offsetGram;
  offsetMoments += other.offsetMoments;
  return *this;
}

NormalEquations equationsOf(double referenceSpeed, const Track& track, const Channels& channels) {
  const Index n = track.frames();
  NormalEquations equations;
  for (const bool fromLeft : {true, false}) {
    MatrixXd design(n, kRegressors * kTerms);
    for (Index f = 0; f < n; ++f) {
      const GaitState state = fromLeft ? track.state(f) : mirrored(track.state(f));
      design.row(f) = features(referenceSpeed, state, gaitHarmonics(state.phase));
    }
    const MatrixXd& observed = fromLeft ? channels.left : channels.right;
    const VectorXd weights = fitWeights(track);
    const MatrixXd weighted = weights.asDiagonal() * design;
    const double frames = std::max(1.0, weights.sum());
    const VectorXd sum = weighted.colwise().sum().transpose();
    const RowVectorXd observedSum = weights.transpose() * observed;
    equations += {weighted.transpose() * design, weighted.transpose() * observed,
                  sum * sum.transpose() / frames, sum * observedSum / frames};
  }
  return equations;
}

MatrixXd solve(const SeriesParams& params, const NormalEquations& equations) {
  VectorXd penalty(equations.gram.rows());
  for (Index i = 0; i < penalty.size(); ++i) {
    const double size = kTypicalSizes[static_cast<std::size_t>(i / kTerms)];
    penalty[i] = (i < kWellKnown * kTerms ? params.ridge : params.rateRidge) * size * size;
  }
  constexpr double kMeanRidge = 1e-6;
  penalty[0] = kMeanRidge;
  const auto solved = [&](double share) -> MatrixXd {
    MatrixXd gram = equations.gram - share * equations.offsetGram;
    gram.diagonal() += penalty;
    return gram.ldlt().solve(equations.moments - share * equations.offsetMoments);
  };
  MatrixXd coefficients = solved(params.lowerOffsetShare);
  const MatrixXd upper = solved(params.upperOffsetShare);
  for (const StoredJoint joint : {StoredJoint::kThorax, StoredJoint::kHead, StoredJoint::kHumerus,
                                  StoredJoint::kRadius, StoredJoint::kHand}) {
    const Index first = 3 * static_cast<Index>(joint);
    coefficients.middleCols<3>(first) = upper.middleCols<3>(first);
  }
  return coefficients;
}

void refinePhase(const PhaseParams& params, const Series& series, const Channels& channels, Track& track) {
  const Index n = track.frames();
  const VectorXd weights = channelWeights(params);
  const MatrixXd penalty = secondDifferencePenalty(n, params.stiffness);
  for (int step = 0; step < params.steps; ++step) {
    constexpr double kLeastCurvature = 1e-3;
    VectorXd curvature = VectorXd::Constant(n, kLeastCurvature);
    VectorXd pull = VectorXd::Zero(n);
    for (Index f = 0; f < n; ++f) {
      if (track.going[f] <= 0.0) continue;
      for (const bool fromLeft : {true, false}) {
        const GaitState state = fromLeft ? track.state(f) : mirrored(track.state(f));
        const RowVectorXd slopes = series.phaseSlopesAt(state);
        const RowVectorXd rest =
            (fromLeft ? channels.left : channels.right).row(f) - series.channelsAt(state);
        curvature[f] += (slopes.array().square() * weights.transpose().array()).sum();
        pull[f] += (slopes.array() * rest.array() * weights.transpose().array()).sum();
      }
    }
    MatrixXd system = penalty;
    system.diagonal() += curvature;
    constexpr double kLargestStep = 0.5;
    const VectorXd move = system.ldlt().solve(pull - penalty * track.phase);
    track.phase += move.cwiseMax(-kLargestStep).cwiseMin(kLargestStep);
  }
}

}  // namespace stridegraph::gait_fit
