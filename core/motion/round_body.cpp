#include "motion/round_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "motion/body_anatomy.h"
#include "motion/body_soles.h"

namespace stridegraph {
namespace {

constexpr double kReferenceHeightMetres = 1.75;
constexpr double kReferenceShoulderMetres = 1.44;
constexpr double kShortestBoneMetres = 0.012;  ///< Of the reference body.

struct Radii {
  double from, to;
};

template <std::size_t N>
Radii pick(const std::array<Radii, N>& table, int depth) {
  return table[std::min(static_cast<std::size_t>(std::max(depth, 0)), N - 1)];
}

/// Radii in metres of a body 1.75 m tall, by where along its limb a bone begins.
Radii radiiOf(const BodyAnatomy& body, std::size_t parent) {
  static constexpr std::array<Radii, 4> kLeg = {
      {{0.088, 0.060}, {0.059, 0.040}, {0.040, 0.036}, {0.034, 0.024}}};
  static constexpr std::array<Radii, 5> kArm = {
      {{0.054, 0.056}, {0.054, 0.041}, {0.041, 0.029}, {0.034, 0.026}, {0.014, 0.010}}};
  static constexpr std::array<Radii, 2> kHead = {{{0.055, 0.055}, {0.092, 0.085}}};
  static constexpr Radii kTorso = {0.105, 0.105};
  const int depth = body.depthInLimb[parent];
  switch (body.limb[parent]) {
    case Limb::kLeg:
      return pick(kLeg, depth);
    case Limb::kArm:
      return pick(kArm, depth);
    case Limb::kHead:
      return pick(kHead, depth);
    case Limb::kTorso:
      return kTorso;
  }
  return kTorso;
}

/// The first joint at or below `root` that has moved away from it sideways: the shoulder below a collarbone.
std::size_t shoulderOf(const BodyAnatomy& body, std::size_t root, const Vec3& middle) {
  std::size_t best = root;
  for (std::size_t joint = root; !body.children[joint].empty();) {
    const std::size_t next = body.children[joint][0];
    const Vec2 here = onFloor(body.at(joint) - middle);
    const Vec2 there = onFloor(body.at(next) - middle);
    if (body.at(next).y() < body.at(joint).y() - 0.06 * body.heightMetres) break;
    if (there.norm() < here.norm() || there.norm() > 0.16 * body.heightMetres) break;
    joint = best = next;
  }
  return best;
}

/// Where the trunk's joints are, as far as limbs tell.
struct Trunk {
  Vec3 hips, shoulders, left, right;
  std::size_t pelvis = 0;  ///< The joint that legs hang on.
  std::size_t chest = 0;   ///< The joint that arms hang on.
};

std::optional<Trunk> trunkOf(const BodyAnatomy& body) {
  const std::vector<std::size_t> legs = body.mainRootsOf(Limb::kLeg);
  const std::vector<std::size_t> arms = body.mainRootsOf(Limb::kArm);
  if (legs.size() < 2 || arms.size() < 2) return std::nullopt;
  Trunk trunk;
  trunk.hips = (body.at(legs[0]) + body.at(legs[1])) / 2.0;
  trunk.left = body.at(shoulderOf(body, arms[0], trunk.hips));
  trunk.right = body.at(shoulderOf(body, arms[1], trunk.hips));
  trunk.shoulders = (trunk.left + trunk.right) / 2.0;
  trunk.pelvis = body.skeleton.joints[legs[0]].parent->value;
  trunk.chest = body.skeleton.joints[arms[0]].parent->value;
  return trunk;
}

/// Three columns side by side from pelvis to collar, and the bars that join them: an oval, seen from above.
void addTrunk(const BodyAnatomy& body, const Trunk& trunk, double scale, std::vector<BodyPart>& parts) {
  const Vec3 across = (trunk.left - trunk.right) / 2.0;
  const Vec3 up(0.0, scale, 0.0);
  const auto between = [&](double share) -> Vec3 {
    return trunk.hips + (trunk.shoulders - trunk.hips) * share;
  };
  const auto add = [&](const Vec3& from, double fromRadius, const Vec3& to, double toRadius) {
    // The lower part goes with the pelvis, the upper part with the chest.
    const auto jointAt = [&](const Vec3& p) {
      return (p - trunk.hips).y() < 0.5 * (trunk.shoulders - trunk.hips).y() ? trunk.pelvis : trunk.chest;
    };
    const std::size_t a = jointAt(from), b = jointAt(to);
    parts.push_back({{JointIndex(a), body.offsetIn(a, from), fromRadius * scale},
                     {JointIndex(b), body.offsetIn(b, to), toRadius * scale}});
  };
  const Vec3 pelvis = trunk.hips + 0.035 * up, waist = between(0.42), ribs = between(0.74),
             collar = between(0.95);
  for (const double side : {-1.0, 1.0}) {
    add(pelvis + 0.46 * side * across, 0.098, waist + 0.34 * side * across, 0.088);
    add(waist + 0.34 * side * across, 0.088, ribs + 0.50 * side * across, 0.104);
    add(ribs + 0.50 * side * across, 0.104, collar + 0.62 * side * across, 0.064);
    add(collar - 0.02 * up, 0.075, trunk.shoulders + 0.92 * side * across - 0.012 * up, 0.055);
  }
  add(pelvis, 0.106, waist, 0.096);
  add(waist, 0.096, ribs, 0.112);
  add(ribs, 0.112, collar, 0.080);
  add(pelvis + 0.46 * across, 0.098, pelvis - 0.46 * across, 0.098);
  add(ribs + 0.50 * across, 0.104, ribs - 0.50 * across, 0.104);
}

/// The topmost joint of the head's branch.
std::size_t topOf(const BodyAnatomy& body, std::size_t root) {
  std::size_t top = root;
  for (std::size_t joint = root; !body.children[joint].empty();) {
    const std::vector<std::size_t>& children = body.children[joint];
    joint = *std::max_element(children.begin(), children.end(), [&](std::size_t a, std::size_t b) {
      return body.heights[a] < body.heights[b];
    });
    top = joint;
  }
  return top;
}

/// Many files end at the neck: the skull is set above the shoulders, and hangs on the last joint that turns.
void addHead(const BodyAnatomy& body, const std::optional<Trunk>& trunk, double scale,
             std::vector<BodyPart>& parts) {
  const std::vector<std::size_t> heads = body.rootsOf(Limb::kHead);
  if (heads.empty()) return;
  const std::size_t end = topOf(body, heads[0]);
  const std::size_t skull =
      body.skeleton.joints[end].isEndSite ? body.skeleton.joints[end].parent->value : end;
  const std::size_t base = trunk ? trunk->chest : body.skeleton.joints[heads[0]].parent->value;
  const Vec3 up(0.0, scale, 0.0);
  const Vec3 root = trunk ? trunk->shoulders : body.at(base);
  Vec3 crown = body.at(end);
  if (crown.y() < root.y() + 0.29 * scale)
    crown = Vec3(body.at(skull).x(), root.y() + 0.29 * scale, body.at(skull).z());
  const auto endAt = [&](std::size_t joint, const Vec3& point, double radius) -> PartEnd {
    return {JointIndex(joint), body.offsetIn(joint, point), radius * scale};
  };
  const Vec3 forehead = crown - 0.100 * up;
  const Vec3 chin = crown - 0.170 * up;
  parts.push_back({endAt(skull, forehead, 0.098), endAt(skull, chin, 0.076)});
  parts.push_back({endAt(skull, chin + 0.02 * up, 0.052), endAt(base, root - 0.03 * up, 0.068)});
}

/// A bone of a limb hangs on its upper joint alone: however its lower joint turns, its shape stays.
void addLimbs(const BodyAnatomy& body, bool hasTrunk, double scale, std::vector<BodyPart>& parts) {
  for (std::size_t i = 1; i < body.skeleton.size(); ++i) {
    const Joint& joint = body.skeleton.joints[i];
    const std::size_t parent = joint.parent->value;
    const Limb limb = body.limb[parent];
    if (joint.offset.norm() < kShortestBoneMetres * scale) continue;
    if (limb == Limb::kHead || (limb == Limb::kTorso && hasTrunk)) continue;
    const Radii radii = radiiOf(body, parent);
    parts.push_back({{JointIndex(parent), Vec3::Zero(), radii.from * scale},
                     {JointIndex(parent), joint.offset, radii.to * scale}});
  }
}

}  // namespace

RoundBody roundBody(const Skeleton& skeleton, const Clip& frames) {
  const BodyAnatomy body = bodyAnatomy(skeleton, frames);
  const std::optional<Trunk> trunk = trunkOf(body);
  const double scale = trunk ? (trunk->shoulders.y() - body.floorMetres) / kReferenceShoulderMetres
                             : body.heightMetres / kReferenceHeightMetres;
  RoundBody round{{}, body.liftMetres, body.standing};
  if (trunk) addTrunk(body, *trunk, scale, round.parts);
  addHead(body, trunk, scale, round.parts);
  addHeels(body, scale, round.parts);
  addLimbs(body, trunk.has_value(), scale, round.parts);
  fitSoles(body, round.parts);
  // Of a skeleton without bones a ball remains.
  if (round.parts.empty()) round.parts.emplace_back();
  return round;
}

std::vector<Capsule> placeParts(const RoundBody& body, const Skeleton& skeleton, const PoseView& pose) {
  std::vector<JointPlacement> placed(skeleton.size());
  placeJoints(skeleton, pose, placed);
  std::vector<Capsule> capsules;
  capsules.reserve(body.parts.size());
  const auto at = [&](const PartEnd& end) -> Vec3 {
    const JointPlacement& joint = placed[end.joint.value];
    return joint.position + joint.rotation * end.offset + body.liftMetres * Vec3::UnitY();
  };
  for (const BodyPart& part : body.parts)
    capsules.push_back({at(part.from), at(part.to), part.from.radius, part.to.radius});
  return capsules;
}

}  // namespace stridegraph
