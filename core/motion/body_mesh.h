#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "motion/round_body.h"

namespace stridegraph {

/// Which joints carry a vertex.
struct VertexCarriers {
  std::array<std::uint16_t, 2> joints = {0, 0};  ///< The second is 0 where the first carries all.
  double secondShare = 0.0;                      ///< Of the second joint, 0..1; the first has what is left.
};

/// Triangles of a body in its standing pose. Outer sides are counter-clockwise.
struct BodyMesh {
  std::vector<std::array<float, 3>> positions;  ///< Metres.
  std::vector<std::array<float, 3>> normals;    ///< Unit length, smooth.
  std::vector<VertexCarriers> carriers;         ///< One for each vertex.
  std::vector<std::uint32_t> indices;           ///< Three for each triangle.
};

/// A closed surface for each part of the body. Where the ends of a part hang on two joints, what lies between
/// them goes over from the one to the other. Parts on joints beyond 65535 have none.
BodyMesh buildBodyMesh(const Skeleton& skeleton, const RoundBody& body);

}  // namespace stridegraph
