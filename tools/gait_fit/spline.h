#pragma once

#include <Eigen/Core>

namespace stridegraph::gait_fit {

/// A uniform cubic B-spline over the frames of a clip, as matrices: value = values * coefficients.
struct Spline {
  Eigen::MatrixXd values;            ///< frames x coefficients
  Eigen::MatrixXd slopes;            ///< The same, a second.
  Eigen::MatrixXd thirdDifferences;  ///< Of the coefficients: what is penalised keeps a smooth path smooth.
};

/// `frames` >= 4, a knot about every `knotFrames` >= 1 frames.
Spline cubicSpline(Eigen::Index frames, double knotFrames, double framesPerSecond);

/// Weighted mean with a raised cosine over 2 * reach + 1 frames; the ends go on as they are.
Eigen::VectorXd smoothed(const Eigen::VectorXd& values, Eigen::Index reach);

/// Change in a second by central differences, one-sided at the ends; at least two frames.
Eigen::VectorXd slopeOf(const Eigen::VectorXd& values, double framesPerSecond);

/// The same angles without jumps of whole turns.
Eigen::VectorXd unwrapped(const Eigen::VectorXd& angles);

}  // namespace stridegraph::gait_fit
