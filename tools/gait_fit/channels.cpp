#include "gait_fit/channels.h"

#include "math/rotation.h"
#include "motion/mirror.h"

namespace stridegraph::gait_fit {
namespace {

using Eigen::Index;

constexpr int kKarcherRounds = 8;

}  // namespace

Pose poseOnPath(const Track& track, Index frame) {
  const PoseView captured = track.clip.pose(static_cast<std::size_t>(frame));
  const Quat pathFromWorld = axisRotation(Axis::kY, Angle::radians(-track.heading[frame]));
  const Vec3 place(track.path(frame, 0), 0.0, track.path(frame, 1));
  Pose pose{pathFromWorld * (captured.rootPosition - place),
            {captured.rotations.begin(), captured.rotations.end()}};
  pose.rotations[0] = pathFromWorld * pose.rotations[0];
  return pose;
}

SidedRotations sidedRotations(const Track& track) {
  SidedRotations sides;
  for (Index f = 0; f < track.frames(); ++f) {
    const Pose pose = poseOnPath(track, f);
    const Pose twin = mirrored(pose);
    auto& left = sides.left.emplace_back();
    auto& right = sides.right.emplace_back();
    for (std::size_t j = 0; j < kStoredJointCount; ++j) {
      const std::size_t joint = indexOf(gaitJointOf(static_cast<StoredJoint>(j)));
      left[j] = pose.rotations[joint];
      right[j] = twin.rotations[joint];
    }
  }
  return sides;
}

MeanRotations meanRotations(std::span<const Track> tracks) {
  MeanRotations means;
  means.fill(Quat::Identity());
  std::vector<SidedRotations> sides;
  double weights = 0.0;
  for (const Track& track : tracks) {
    sides.push_back(sidedRotations(track));
    weights += 2.0 * track.going.sum();
  }
  for (int round = 0; round < kKarcherRounds; ++round) {
    for (std::size_t j = 0; j < kStoredJointCount; ++j) {
      Vec3 sum = Vec3::Zero();
      for (std::size_t t = 0; t < tracks.size(); ++t)
        for (Index f = 0; f < tracks[t].frames(); ++f) {
          const auto at = static_cast<std::size_t>(f);
          const Quat back = means[j].conjugate();
          sum += tracks[t].going[f] * (toRotationVector(back * sides[t].left[at][j]) +
                                       toRotationVector(back * sides[t].right[at][j]));
        }
      means[j] = (means[j] * fromRotationVector(sum / weights)).normalized();
    }
  }
  return means;
}

Channels channelsOf(const Track& track, const MeanRotations& means) {
  const SidedRotations sides = sidedRotations(track);
  Channels channels{Eigen::MatrixXd(track.frames(), kChannelCount),
                    Eigen::MatrixXd(track.frames(), kChannelCount)};
  for (Index f = 0; f < track.frames(); ++f) {
    const auto at = static_cast<std::size_t>(f);
    for (std::size_t j = 0; j < kStoredJointCount; ++j) {
      const Index first = 3 * static_cast<Index>(j);
      const Quat back = means[j].conjugate();
      channels.left.block<1, 3>(f, first) = toRotationVector(back * sides.left[at][j]).transpose();
      channels.right.block<1, 3>(f, first) = toRotationVector(back * sides.right[at][j]).transpose();
    }
    const Vec3 offset = poseOnPath(track, f).rootPosition;
    channels.left.block<1, 3>(f, kRotationChannels) = offset.transpose();
    channels.right.block<1, 3>(f, kRotationChannels) = mirrored(offset).transpose();
  }
  return channels;
}

}  // namespace stridegraph::gait_fit
