#pragma once

#include <array>
#include <vector>

#include "math/rotation.h"
#include "motion/bvh_layout.h"

namespace stridegraph {

/// One joint's rotations as the angles of a BVH's rotation channels, in degrees.
struct BvhEulerTrack {
  std::vector<Axis> axes;                      ///< The channels, in file order; at most three, all different.
  std::vector<std::array<double, 3>> degrees;  ///< For each frame; only the first axes.size() count.
};

/// `axes` with those of z, x and y at the end that are not among them.
std::vector<Axis> withAllAxes(std::vector<Axis> axes);

/// Angles for `rotations` about `axes` (at most three, all different), continuous from frame to frame: of the
/// two sets of angles that give the same rotation the nearer to the frame before, whole turns removed, and in
/// gimbal lock, where many pairs of outer angles do, the nearest pair. A body that turns in circles gets
/// angles of many turns. While a rotation changes little from frame to frame, no angle changes by much more
/// than 90 degrees, and by so much only where it passes close by gimbal lock. When fewer than three axes
/// cannot give every rotation within 0.001 degrees, the missing ones are added at the end.
BvhEulerTrack bvhEulerTrack(std::vector<Axis> axes, const std::vector<Quat>& rotations);

}  // namespace stridegraph
