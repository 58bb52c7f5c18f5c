#pragma once

#include <vector>

namespace stridegraph {

struct MeshData {
  std::vector<float> vertices;
  std::vector<unsigned short> indices;
};

/// Corners (-1, -1) to (1, 1): x, y.
MeshData quadMesh();
/// A cube with bevelled edges: which corner (+-1 each), normal. The shader moves faces out along normals.
MeshData bevelledCubeMesh();
/// Two half spheres and what joins them: direction around the bone (two numbers), share of the way from the
/// seam to the pole, and the end (0 or 1) that a vertex belongs to.
MeshData roundConeMesh();

}  // namespace stridegraph
