#include "motion/bvh_channels.h"

#include <algorithm>

#include "math/rotation.h"

namespace stridegraph {

bool isPosition(BvhChannel channel) {
  return channel <= BvhChannel::kZPosition;
}

Eigen::Index axisOf(BvhChannel channel) {
  return static_cast<Eigen::Index>(channel) % 3;
}

bool hasPositionChannels(const BvhJoint& joint) {
  return std::any_of(joint.channels.begin(), joint.channels.end(), isPosition);
}

std::span<const double> valuesIn(const BvhJoint& joint, std::span<const double> row) {
  return row.subspan(joint.channels.empty() ? 0 : joint.firstColumn, joint.channels.size());
}

Vec3 positionIn(const BvhJoint& joint, std::span<const double> row) {
  Vec3 position = Vec3::Zero();
  const std::span<const double> values = valuesIn(joint, row);
  for (std::size_t c = 0; c < values.size(); ++c) {
    if (isPosition(joint.channels[c])) position[axisOf(joint.channels[c])] = values[c];
  }
  return position;
}

Vec3 alongChannels(const BvhJoint& joint, const Vec3& vector) {
  Vec3 along = Vec3::Zero();
  for (const BvhChannel channel : joint.channels) {
    if (isPosition(channel)) along[axisOf(channel)] = vector[axisOf(channel)];
  }
  return along;
}

Quat rotationIn(const BvhJoint& joint, std::span<const double> row) {
  Quat rotation = Quat::Identity();
  const std::span<const double> values = valuesIn(joint, row);
  for (std::size_t c = 0; c < values.size(); ++c) {
    const BvhChannel channel = joint.channels[c];
    if (isPosition(channel)) continue;
    rotation = rotation * axisRotation(static_cast<Axis>(axisOf(channel)), Angle::degrees(values[c]));
  }
  return rotation;
}

}  // namespace stridegraph
