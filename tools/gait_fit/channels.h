#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "gait_fit/track.h"

namespace stridegraph::gait_fit {

/// What the series describe: three numbers of the rotation vector of each stored joint about its mean, then
/// the root's offset from the smooth path: lateral, height, forward (metres).
inline constexpr Eigen::Index kRotationChannels = 3 * static_cast<Eigen::Index>(kStoredJointCount);
inline constexpr Eigen::Index kChannelCount = kRotationChannels + 3;

/// The captured body at a frame as gaitPose() shows it: in the frame that moves with the smooth path.
Pose poseOnPath(const Track& track, Eigen::Index frame);

using MeanRotations = std::array<Quat, kStoredJointCount>;

/// Rotations of the stored joints, seen from the left and, reflected, from the right, so that one model fits
/// both: frame by frame, in the frame of the path.
struct SidedRotations {
  std::vector<std::array<Quat, kStoredJointCount>> left;
  std::vector<std::array<Quat, kStoredJointCount>> right;
};
SidedRotations sidedRotations(const Track& track);

/// The Karcher mean (Karcher 1977) of each stored joint over the going frames of all tracks, both sides
/// together, so that it is its own mirror image where the joint is in the middle.
MeanRotations meanRotations(std::span<const Track> tracks);

/// frames x kChannelCount, for the left and for the reflected right side.
struct Channels {
  Eigen::MatrixXd left;
  Eigen::MatrixXd right;
};
Channels channelsOf(const Track& track, const MeanRotations& means);

}  // namespace stridegraph::gait_fit
