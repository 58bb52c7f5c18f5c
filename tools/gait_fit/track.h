#pragma once

#include <Eigen/Core>

#include "motion/clip.h"
#include "motion/gait_model.h"

namespace stridegraph::gait_fit {

/// A clip of the gait body taken apart: the smooth path that it follows, how it goes along it, and where in
/// the gait cycle it is. Vectors have one entry for each frame.
struct Track {
  Clip clip;
  Eigen::VectorXd heading;           ///< Of the smooth path, rad, without jumps.
  Eigen::MatrixX2d path;             ///< Smooth place of the root on the floor, metres.
  Eigen::VectorXd speed;             ///< m/s
  Eigen::VectorXd turnRate;          ///< rad/s, positive to the left
  Eigen::VectorXd acceleration;      ///< m/s^2
  Eigen::VectorXd turnAcceleration;  ///< rad/s^2
  Eigen::VectorXd slip;              ///< Direction of the path less heading, rad.
  Eigen::VectorXd phase;             ///< rad, grows; empty as long as it is not known.
  Eigen::VectorXd going;             ///< 1 in frames that are fast enough to have a phase, else 0.

  Eigen::Index frames() const { return static_cast<Eigen::Index>(clip.frameCount()); }
  GaitState state(Eigen::Index frame) const {
    return {phase[frame], speed[frame], turnRate[frame], turnAcceleration[frame], acceleration[frame]};
  }
};

/// How the root's motion is split into a smooth path and the oscillation of the steps about it.
struct SplitParams {
  double knotFrames = 6.0;         ///< Between knots of the spline, >= 1.
  double thirdDifference = 20.0;   ///< Penalty on its third differences, >= 0.
  int harmonics = 3;               ///< Of the oscillation, 0..5.
  double oscillationRidge = 0.09;  ///< Penalty on its amplitudes, > 0.
  Eigen::Index rateReach = 4;      ///< Frames on either side over which rates are smoothed, >= 0.
};

/// Fills heading, path and rates of a track by linear least squares: a cubic spline plus, where a phase is
/// known, a Fourier series of it, in heading and in (lateral, forward) place. Splines neither drift nor need
/// a differentiated root. The clip has at least kShortestClip frames.
void splitRoot(const SplitParams& params, Track& track);
inline constexpr std::size_t kShortestClip = 20;

/// Frames at either end of a clip in which its rates are not to be trusted.
inline constexpr Eigen::Index kEndFrames = 3;

/// How far the left ankle is ahead of the right one along the heading, metres.
Eigen::VectorXd ankleSeparation(const Track& track);

/// A first phase: the angle of ankle separation and its rate (phase 0: left foot foremost), and `going`:
/// frames faster than `minimumSpeed`.
void estimatePhase(double minimumSpeed, Track& track);

}  // namespace stridegraph::gait_fit
