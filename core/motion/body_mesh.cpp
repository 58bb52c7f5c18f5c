#include "motion/body_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "motion/kinematics.h"

namespace stridegraph {
namespace {

constexpr std::uint32_t kSides = 16;
/// Rings of a half ball, its pole not counted.
constexpr std::size_t kCapRings = 5;
/// Rings between the ends of a part that hangs on two joints.
constexpr std::size_t kBetween = 4;
/// A cone leans no more than this where a ball is almost inside the other, as the sine of the angle.
constexpr double kMostLean = 0.9;
constexpr double kShortestPartMetres = 1e-5;

std::array<float, 3> toFloats(const Vec3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

/// A round cone with its axes.
class PartShape {
 public:
  explicit PartShape(const Capsule& capsule)
      : capsule_(capsule), length_((capsule.to - capsule.from).norm()) {
    axis_ = length_ > kShortestPartMetres ? Vec3((capsule.to - capsule.from) / length_) : Vec3(Vec3::UnitY());
    // The first side looks down, so that level parts touch the floor with a whole row of vertices.
    const Vec3 helper = std::abs(axis_.y()) < 0.99 ? Vec3(-Vec3::UnitY()) : Vec3(Vec3::UnitX());
    across_ = (helper - axis_ * helper.dot(axis_)).normalized();
    second_ = axis_.cross(across_);
  }

  /// Latitude at which the cone touches both balls.
  double seam() const {
    const double reach = std::max(length_, 1e-4);
    return std::asin(std::clamp((capsule_.fromRadius - capsule_.toRadius) / reach, -kMostLean, kMostLean));
  }
  /// Direction outward on a circle of latitude, -90 degrees at the pole of `from`.
  Vec3 normal(double latitude, std::uint32_t side) const {
    const double turn = 2.0 * std::numbers::pi * side / kSides;
    const Vec3 outward = across_ * std::cos(turn) + second_ * std::sin(turn);
    return (outward * std::cos(latitude) + axis_ * std::sin(latitude)).normalized();
  }
  /// The point whose surface looks that way, `share` of the way from one ball to the other.
  Vec3 point(double share, const Vec3& normal) const {
    const double radius = capsule_.fromRadius + (capsule_.toRadius - capsule_.fromRadius) * share;
    return capsule_.from + (capsule_.to - capsule_.from) * share + normal * radius;
  }
  bool isBall() const { return length_ <= kShortestPartMetres && capsule_.fromRadius == capsule_.toRadius; }

 private:
  const Capsule& capsule_;
  double length_;
  Vec3 axis_;
  Vec3 across_;
  Vec3 second_;
};

class MeshBuilder {
 public:
  void add(const Capsule& capsule, std::uint16_t fromJoint, std::uint16_t toJoint) {
    const PartShape shape(capsule);
    const double seam = shape.seam();
    from_ = fromJoint;
    to_ = toJoint;
    addPole(shape, 0.0, -kQuarter);
    for (std::size_t ring = 1; ring <= kCapRings; ++ring)
      addRing(shape, 0.0, -kQuarter + (seam + kQuarter) * shareOf(ring), ring > 1);
    if (fromJoint != toJoint) {
      for (std::size_t ring = 1; ring <= kBetween; ++ring)
        addRing(shape, static_cast<double>(ring) / static_cast<double>(kBetween + 1), seam, true);
    }
    // The two seams of a ball are one.
    for (std::size_t ring = kCapRings - (shape.isBall() ? 1 : 0); ring >= 1; --ring)
      addRing(shape, 1.0, kQuarter - (kQuarter - seam) * shareOf(ring), true);
    addPole(shape, 1.0, kQuarter);
  }

  BodyMesh mesh;

 private:
  static constexpr double kQuarter = 0.5 * std::numbers::pi;

  static double shareOf(std::size_t ring) {
    return static_cast<double>(ring) / static_cast<double>(kCapRings);
  }

  std::uint32_t size() const { return static_cast<std::uint32_t>(mesh.positions.size()); }

  void addVertex(const PartShape& shape, double share, const Vec3& normal) {
    mesh.positions.push_back(toFloats(shape.point(share, normal)));
    mesh.normals.push_back(toFloats(normal));
    VertexCarriers carriers{{from_, 0}, 0.0};
    if (share == 1.0) carriers.joints[0] = to_;
    if (share > 0.0 && share < 1.0) carriers = {{from_, to_}, share};
    mesh.carriers.push_back(carriers);
  }

  void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
  }

  /// The first pole stands before the first ring, the second one behind the last.
  void addPole(const PartShape& shape, double share, double latitude) {
    const std::uint32_t pole = size();
    addVertex(shape, share, shape.normal(latitude, 0));
    for (std::uint32_t side = 0; side < kSides; ++side) {
      const std::uint32_t next = (side + 1) % kSides;
      if (latitude < 0.0) {
        addTriangle(pole, pole + 1 + next, pole + 1 + side);
      } else {
        addTriangle(pole, pole - kSides + side, pole - kSides + next);
      }
    }
  }

  /// A circle of latitude, and the band between it and the ring before.
  void addRing(const PartShape& shape, double share, double latitude, bool hasBand) {
    const std::uint32_t high = size();
    const std::uint32_t low = high - kSides;
    for (std::uint32_t side = 0; side < kSides; ++side) addVertex(shape, share, shape.normal(latitude, side));
    for (std::uint32_t side = 0; hasBand && side < kSides; ++side) {
      const std::uint32_t next = (side + 1) % kSides;
      addTriangle(low + side, low + next, high + side);
      addTriangle(low + next, high + next, high + side);
    }
  }

  std::uint16_t from_ = 0;
  std::uint16_t to_ = 0;
};

}  // namespace

BodyMesh buildBodyMesh(const Skeleton& skeleton, const RoundBody& body) {
  constexpr std::size_t kMostJoints = std::numeric_limits<std::uint16_t>::max();
  Pose standing = body.standing;
  standing.rootPosition.y() -= body.liftMetres;
  const std::vector<Capsule> capsules = placeParts(body, skeleton, standing.view());
  MeshBuilder builder;
  for (std::size_t i = 0; i < capsules.size(); ++i) {
    const std::size_t from = body.parts[i].from.joint.value;
    const std::size_t to = body.parts[i].to.joint.value;
    if (from > kMostJoints || to > kMostJoints) continue;
    builder.add(capsules[i], static_cast<std::uint16_t>(from), static_cast<std::uint16_t>(to));
  }
  // Somebody is seen in any case: a ball at the root.
  if (builder.mesh.indices.empty()) {
    const Vec3& root = body.standing.rootPosition;
    builder.add({root, root, PartEnd{}.radius, PartEnd{}.radius}, 0, 0);
  }
  return std::move(builder.mesh);
}

}  // namespace stridegraph
