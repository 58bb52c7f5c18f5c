#include "render/meshes.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

namespace stridegraph {

namespace {

using Index = unsigned short;

/// Adds a triangle that is seen from the side to which `outwards` points.
void addTriangle(MeshData& mesh, std::array<Index, 3> corners, const Eigen::Vector3f& outwards) {
  const auto at = [&mesh](Index i) -> Eigen::Vector3f {
    const float* v = &mesh.vertices[static_cast<std::size_t>(i) * 6];
    // A small bevel tells apart the three vertices that share a corner.
    return Eigen::Vector3f(v[0], v[1], v[2]) + 0.1F * Eigen::Vector3f(v[3], v[4], v[5]);
  };
  const Eigen::Vector3f normal = (at(corners[1]) - at(corners[0])).cross(at(corners[2]) - at(corners[0]));
  if (normal.dot(outwards) < 0.0F) std::swap(corners[1], corners[2]);
  mesh.indices.insert(mesh.indices.end(), corners.begin(), corners.end());
}

/// Index of the vertex of a corner (bit a set: positive along axis a) that belongs to the face across `axis`.
Index vertexOf(int corner, int axis) {
  return static_cast<Index>(corner * 3 + axis);
}

float sideOf(int corner, int axis) {
  return (corner >> axis & 1) != 0 ? 1.0F : -1.0F;
}

void addFace(MeshData& mesh, int axis, int positive) {
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const int base = positive << axis;
  const Eigen::Vector3f outwards = Eigen::Vector3f::Unit(axis) * sideOf(base, axis);
  const Index a = vertexOf(base, axis);
  const Index b = vertexOf(base | 1 << u, axis);
  const Index c = vertexOf(base | 1 << u | 1 << v, axis);
  const Index d = vertexOf(base | 1 << v, axis);
  addTriangle(mesh, {a, b, c}, outwards);
  addTriangle(mesh, {a, c, d}, outwards);
}

/// The bevel between the faces across u and v, along `axis`.
void addBevel(MeshData& mesh, int axis, int uPositive, int vPositive) {
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const int low = uPositive << u | vPositive << v;
  const int high = low | 1 << axis;
  const Eigen::Vector3f outwards =
      Eigen::Vector3f::Unit(u) * sideOf(low, u) + Eigen::Vector3f::Unit(v) * sideOf(low, v);
  addTriangle(mesh, {vertexOf(low, u), vertexOf(low, v), vertexOf(high, v)}, outwards);
  addTriangle(mesh, {vertexOf(low, u), vertexOf(high, v), vertexOf(high, u)}, outwards);
}

}  // namespace

MeshData quadMesh() {
  return {{-1.0F, -1.0F, 1.0F, -1.0F, 1.0F, 1.0F, -1.0F, 1.0F}, {0, 1, 2, 0, 2, 3}};
}

MeshData bevelledCubeMesh() {
  MeshData mesh;
  for (int corner = 0; corner < 8; ++corner) {
    for (int axis = 0; axis < 3; ++axis) {
      for (int i = 0; i < 3; ++i) mesh.vertices.push_back(sideOf(corner, i));
      for (int i = 0; i < 3; ++i) mesh.vertices.push_back(i == axis ? sideOf(corner, axis) : 0.0F);
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (int positive = 0; positive < 2; ++positive) addFace(mesh, axis, positive);
    for (int sides = 0; sides < 4; ++sides) addBevel(mesh, axis, sides & 1, sides >> 1);
  }
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3f outwards(sideOf(corner, 0), sideOf(corner, 1), sideOf(corner, 2));
    addTriangle(mesh, {vertexOf(corner, 0), vertexOf(corner, 1), vertexOf(corner, 2)}, outwards);
  }
  return mesh;
}

MeshData roundConeMesh() {
  constexpr int kAround = 22;
  constexpr int kUp = 6;  // Rings of each half, pole and seam included.
  MeshData mesh;
  for (int ring = 0; ring < 2 * kUp; ++ring) {
    const bool upper = ring >= kUp;
    const int fromSeam = upper ? ring - kUp : kUp - 1 - ring;
    const float share = static_cast<float>(fromSeam) / (kUp - 1);
    for (int i = 0; i < kAround; ++i) {
      const float turn = static_cast<float>(i) / kAround * 2.0F * std::numbers::pi_v<float>;
      mesh.vertices.insert(mesh.vertices.end(), {std::cos(turn), std::sin(turn), share, upper ? 1.0F : 0.0F});
    }
  }
  for (int ring = 0; ring + 1 < 2 * kUp; ++ring) {
    for (int i = 0; i < kAround; ++i) {
      const auto a = static_cast<Index>(ring * kAround + i);
      const auto b = static_cast<Index>(ring * kAround + (i + 1) % kAround);
      const auto c = static_cast<Index>(a + kAround);
      const auto d = static_cast<Index>(b + kAround);
      mesh.indices.insert(mesh.indices.end(), {a, c, b, b, c, d});
    }
  }
  return mesh;
}

}  // namespace stridegraph
