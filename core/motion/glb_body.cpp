#include "motion/glb_body.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace stridegraph {
namespace {

constexpr std::size_t kSides = 12;
/// Rings from the tip of a cap to its rim, the tip not counted.
constexpr std::size_t kCapRings = 3;
constexpr double kShortestBoneMetres = 1e-3;
constexpr double kBallRadiusMetres = 0.035;
constexpr double kRadiusPerLength = 0.16;
constexpr double kThinnestMetres = 0.018;
constexpr double kThickestMetres = 0.07;
constexpr double kTaper = 0.75;
constexpr std::size_t kMostJoints = std::numeric_limits<std::uint16_t>::max();

/// A capsule that begins at `base`, whose radius there is `baseRadius`.
struct Capsule {
  Vec3 base = Vec3::Zero();
  Vec3 axis = Vec3::UnitY();  ///< Unit length.
  double length = 0.0;
  double baseRadius = kBallRadiusMetres;
  double tipRadius = kBallRadiusMetres;
};

std::array<float, 3> toFloats(const Vec3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

class MeshBuilder {
 public:
  void add(const Capsule& capsule, std::size_t joint) {
    joint_ = static_cast<std::uint16_t>(joint);
    const Vec3 helper = std::abs(capsule.axis.x()) < 0.7 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY());
    across_ = capsule.axis.cross(helper).normalized();
    second_ = capsule.axis.cross(across_);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::size_t ring = 0; ring <= kCapRings; ++ring) {
      addRing(capsule, capsule.base, capsule.baseRadius, angleOf(ring) - 0.5 * std::numbers::pi);
    }
    const Vec3 tip = capsule.base + capsule.axis * capsule.length;
    for (std::size_t ring = 0; ring <= kCapRings; ++ring) {
      addRing(capsule, tip, capsule.tipRadius, angleOf(ring));
    }
    for (std::uint32_t ring = 0; ring + 1 < 2 * (kCapRings + 1); ++ring) joinRings(first, ring);
  }

  BodyMesh mesh;

 private:
  static double angleOf(std::size_t ring) {
    return 0.5 * std::numbers::pi * static_cast<double>(ring) / static_cast<double>(kCapRings);
  }

  /// A circle of latitude of the ball about `centre`; latitude -90 degrees is the end at the base.
  void addRing(const Capsule& capsule, const Vec3& centre, double radius, double latitude) {
    for (std::size_t side = 0; side < kSides; ++side) {
      const double turn = 2.0 * std::numbers::pi * static_cast<double>(side) / static_cast<double>(kSides);
      const Vec3 outward = across_ * std::cos(turn) + second_ * std::sin(turn);
      const Vec3 normal = (outward * std::cos(latitude) + capsule.axis * std::sin(latitude)).normalized();
      mesh.positions.push_back(toFloats(centre + normal * radius));
      mesh.normals.push_back(toFloats(normal));
      mesh.joints.push_back(joint_);
    }
  }

  /// The band between a ring and the next; at the tips, where a ring is a point, half of it is left out.
  void joinRings(std::uint32_t first, std::uint32_t ring) {
    constexpr auto kCount = static_cast<std::uint32_t>(kSides);
    constexpr std::uint32_t kLastBand = 2 * kCapRings;
    for (std::uint32_t side = 0; side < kCount; ++side) {
      const std::uint32_t next = (side + 1) % kCount;
      const std::uint32_t low = first + ring * kCount;
      const std::uint32_t high = low + kCount;
      if (ring != 0) mesh.indices.insert(mesh.indices.end(), {low + side, low + next, high + side});
      if (ring != kLastBand) mesh.indices.insert(mesh.indices.end(), {low + next, high + next, high + side});
    }
  }

  std::uint16_t joint_ = 0;
  Vec3 across_ = Vec3::Zero();
  Vec3 second_ = Vec3::Zero();
};

Capsule capsuleAlong(const Vec3& base, const Vec3& bone) {
  const double length = bone.norm();
  const double radius = std::clamp(kRadiusPerLength * length, kThinnestMetres, kThickestMetres);
  return {base, bone / length, length, radius, kTaper * radius};
}

}  // namespace

BodyMesh buildBodyMesh(const Skeleton& skeleton) {
  MeshBuilder builder;
  std::vector<Vec3> rest(skeleton.size(), Vec3::Zero());
  std::vector<bool> hasBone(skeleton.size(), false);
  const std::size_t joints = std::min(skeleton.size(), kMostJoints);
  for (std::size_t j = 1; j < joints; ++j) {
    const Joint& joint = skeleton.joints[j];
    const std::size_t parent = joint.parent->value;
    rest[j] = rest[parent] + joint.offset;
    if (joint.offset.norm() < kShortestBoneMetres) continue;
    hasBone[parent] = true;
    builder.add(capsuleAlong(rest[parent], joint.offset), parent);
  }
  std::vector<bool> hasJointBelow(skeleton.size(), false);
  for (std::size_t j = 1; j < joints; ++j) {
    if (!skeleton.joints[j].isEndSite) hasJointBelow[skeleton.joints[j].parent->value] = true;
  }
  for (std::size_t j = 0; j < joints; ++j) {
    if (skeleton.joints[j].isEndSite || hasJointBelow[j] || hasBone[j]) continue;
    Capsule ball;
    ball.base = rest[j];
    builder.add(ball, j);
  }
  return std::move(builder.mesh);
}

}  // namespace stridegraph
