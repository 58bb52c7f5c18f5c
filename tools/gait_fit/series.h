#pragma once

#include <span>

#include "gait_fit/channels.h"

namespace stridegraph::gait_fit {

/// How the series are fitted.
struct SeriesParams {
  double referenceSpeed = 1.3;  ///< m/s: u of the regressors is counted from here.
  double ridge = 5.0;           ///< Penalty on the coefficients of 1, u, w and w^2, in frames, >= 0.
  double rateRidge = 100.0;     ///< The same for the other regressors, each in its typical size, >= 0.
  /// Share of a clip's mean that is put down to a constant offset of the whole clip (the way a head is held
  /// in one take) and left out of the fit, 0..1: of thorax, head and arms, and of pelvis, legs and root,
  /// which hardly have one.
  double upperOffsetShare = 0.7;
  double lowerOffsetShare = 0.0;
};

/// Every channel as a linear function of regressors x harmonics.
struct Series {
  double referenceSpeed = 1.3;
  MeanRotations means;
  Eigen::MatrixXd coefficients;  ///< (regressor, term) x channel

  /// The channels at a state, seen from the left.
  Eigen::RowVectorXd channelsAt(const GaitState& state) const;
  /// Their change with the phase.
  Eigen::RowVectorXd phaseSlopesAt(const GaitState& state) const;
};

/// Sums over frames from which coefficients follow: those of several clips add up, so that leaving a clip out
/// costs a subtraction.
struct NormalEquations {
  Eigen::MatrixXd gram;
  Eigen::MatrixXd moments;
  Eigen::MatrixXd offsetGram;  ///< The part of both that constant offsets of clips could explain.
  Eigen::MatrixXd offsetMoments;

  NormalEquations& operator+=(const NormalEquations& other);
};

/// One clip's share, its left and its reflected right side as two observations of the same series, which
/// makes every fit exactly mirror-symmetrical.
NormalEquations equationsOf(double referenceSpeed, const Track& track, const Channels& channels);

/// Ridge regression (Hoerl and Kennard 1970).
Eigen::MatrixXd solve(const SeriesParams& params, const NormalEquations& equations);

/// How a clip's phase is fitted to given series.
struct PhaseParams {
  double stiffness = 5.0;     ///< Penalty on second differences of the phase, > 0.
  double offsetWeight = 4.0;  ///< What a squared metre counts beside a squared radian, >= 0.
  int steps = 3;              ///< Of Gauss and Newton, >= 1.
};

/// Moves the phase of a track to where the series say its poses are: Gauss-Newton on all channels at once.
void refinePhase(const PhaseParams& params, const Series& series, const Channels& channels, Track& track);

}  // namespace stridegraph::gait_fit
