#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "motion/skeleton.h"

namespace stridegraph {

/// Triangles of a body in the skeleton's rest pose (all rotations zero, root at the origin), each vertex
/// fixed to one joint. Outer sides are counter-clockwise.
struct BodyMesh {
  std::vector<std::array<float, 3>> positions;  ///< Metres.
  std::vector<std::array<float, 3>> normals;    ///< Unit length, smooth.
  std::vector<std::uint16_t> joints;   ///< For each vertex the joint of the skeleton that carries it.
  std::vector<std::uint32_t> indices;  ///< Three for each triangle.
};

/// A body of tapered capsules, one for each bone of more than a millimetre, and balls at joints where the
/// skeleton ends without one. Bones beyond joint 65535 have no capsule.
BodyMesh buildBodyMesh(const Skeleton& skeleton);

}  // namespace stridegraph
