#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace stridegraph {

/// A point or direction in space: x, y (up), z. Metres unless the name says otherwise.
using Vec3 = Eigen::Vector3d;

/// A point or direction on the floor: x(), y() hold the world's x and z. Metres.
using Vec2 = Eigen::Vector2d;

using Mat3 = Eigen::Matrix3d;

/// A rotation. Texts and files say w, x, y, z; Eigen's own memory order (x, y, z, w) stays inside core.
using Quat = Eigen::Quaterniond;

/// The floor point under a point in space.
inline Vec2 onFloor(const Vec3& point) {
  return {point.x(), point.z()};
}

}  // namespace stridegraph
