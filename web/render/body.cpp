#include "render/body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "motion/kinematics.h"

namespace stridegraph {

namespace {

constexpr double kReferenceHeightMetres = 1.75;
constexpr double kReferenceShoulderMetres = 1.44;

enum class Limb { kTorso, kLeg, kArm, kHead };

struct Anatomy {
  const Skeleton& skeleton;
  std::vector<JointPlacement> placed;
  std::vector<std::vector<std::size_t>> children;
  std::vector<double> lowest, highest;  ///< Of everything that hangs on a joint.
  std::vector<Limb> limb;
  std::vector<int> depthInLimb;  ///< 0 for the joint where a limb begins.
  double floor = 0.0, top = 0.0;

  double height() const { return std::max(top - floor, 0.3); }
  const Vec3& at(std::size_t joint) const { return placed[joint].position; }
};

void measure(Anatomy& body, std::size_t joint) {
  body.lowest[joint] = body.highest[joint] = body.at(joint).y();
  for (const std::size_t child : body.children[joint]) {
    measure(body, child);
    body.lowest[joint] = std::min(body.lowest[joint], body.lowest[child]);
    body.highest[joint] = std::max(body.highest[joint], body.highest[child]);
  }
}

void mark(Anatomy& body, std::size_t joint, Limb limb, int depth) {
  body.limb[joint] = limb;
  body.depthInLimb[joint] = depth;
  // A joint on top of another (zero offset) is a twist joint, not a further part of the limb.
  for (const std::size_t child : body.children[joint]) {
    const bool longBone = (body.at(child) - body.at(joint)).norm() > 0.02 * body.height();
    mark(body, child, limb, depth + (longBone ? 1 : 0));
  }
}

/// Walks up the torso: whatever branches off it is a leg, an arm or the head.
void divide(Anatomy& body, std::size_t joint) {
  body.limb[joint] = Limb::kTorso;
  const double kneeHeight = body.floor + 0.2 * body.height();
  for (const std::size_t child : body.children[joint]) {
    if (body.lowest[child] < kneeHeight) {
      mark(body, child, Limb::kLeg, 0);
    } else if (body.highest[child] > body.top - 1e-6) {
      // The branch with the head goes on as torso while it carries more than the head itself.
      std::size_t ends = 0;
      std::vector<std::size_t> open = {child};
      while (!open.empty()) {
        const std::size_t next = open.back();
        open.pop_back();
        if (body.children[next].empty()) ++ends;
        open.insert(open.end(), body.children[next].begin(), body.children[next].end());
      }
      if (ends <= 1) mark(body, child, Limb::kHead, 0);
      if (ends > 1) divide(body, child);
    } else {
      mark(body, child, Limb::kArm, 0);
    }
  }
}

Anatomy anatomyOf(const Skeleton& skeleton, const PoseView& standing) {
  Anatomy body{skeleton, {}, {}, {}, {}, {}, {}};
  const std::size_t count = skeleton.size();
  body.placed.resize(count);
  placeJoints(skeleton, standing, body.placed);
  body.children.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (skeleton.joints[i].parent) body.children[skeleton.joints[i].parent->value].push_back(i);
  }
  body.lowest.resize(count);
  body.highest.resize(count);
  body.limb.assign(count, Limb::kTorso);
  body.depthInLimb.assign(count, 0);
  measure(body, 0);
  body.floor = body.lowest[0];
  body.top = body.highest[0];
  divide(body, 0);
  return body;
}

struct Radii {
  double from, to;
};

template <std::size_t N>
Radii pick(const std::array<Radii, N>& table, int depth) {
  return table[std::min(static_cast<std::size_t>(std::max(depth, 0)), N - 1)];
}

/// Radii in metres of a body 1.75 m tall, by where along its limb a bone begins.
Radii radiiOf(const Anatomy& body, std::size_t parent) {
  static constexpr std::array<Radii, 4> kLeg = {
      {{0.088, 0.060}, {0.059, 0.040}, {0.040, 0.036}, {0.034, 0.024}}};
  static constexpr std::array<Radii, 5> kArm = {
      {{0.054, 0.056}, {0.054, 0.041}, {0.041, 0.029}, {0.034, 0.026}, {0.014, 0.010}}};
  static constexpr std::array<Radii, 2> kHead = {{{0.055, 0.055}, {0.092, 0.085}}};
  static constexpr std::array<Radii, 1> kTorso = {{{0.105, 0.105}}};
  const int depth = body.depthInLimb[parent];
  switch (body.limb[parent]) {
    case Limb::kLeg:
      return pick(kLeg, depth);
    case Limb::kArm:
      return pick(kArm, depth);
    case Limb::kHead:
      return pick(kHead, depth);
    case Limb::kTorso:
      return kTorso[0];
  }
  return kTorso[0];
}

/// A point given in the world at the standing pose, as an offset in a joint's axes.
Vec3 offsetIn(const Anatomy& body, std::size_t joint, const Vec3& point) {
  return body.placed[joint].rotation.conjugate() * (point - body.at(joint));
}

std::vector<std::size_t> limbRoots(const Anatomy& body, Limb limb) {
  std::vector<std::size_t> roots;
  for (std::size_t i = 1; i < body.skeleton.size(); ++i) {
    const std::size_t parent = body.skeleton.joints[i].parent->value;
    if (body.limb[i] == limb && body.limb[parent] != limb) roots.push_back(i);
  }
  return roots;
}

/// The first joint at or below `root` that has moved away from it sideways: the shoulder below a collarbone.
std::size_t shoulderOf(const Anatomy& body, std::size_t root, const Vec3& middle) {
  std::size_t best = root;
  for (std::size_t joint = root; !body.children[joint].empty();) {
    const std::size_t next = body.children[joint][0];
    const Vec2 here = onFloor(body.at(joint) - middle);
    const Vec2 there = onFloor(body.at(next) - middle);
    if (body.at(next).y() < body.at(joint).y() - 0.06 * body.height()) break;
    if (there.norm() < here.norm() || there.norm() > 0.16 * body.height()) break;
    joint = best = next;
  }
  return best;
}

/// Where the trunk's joints are, as far as limbs tell.
struct Trunk {
  Vec3 hips, shoulders, left, right;
  std::size_t chest = 0;  ///< The joint that arms hang on.
};

std::optional<Trunk> trunkOf(const Anatomy& body) {
  const std::vector<std::size_t> legs = limbRoots(body, Limb::kLeg);
  const std::vector<std::size_t> arms = limbRoots(body, Limb::kArm);
  if (legs.size() < 2 || arms.size() < 2) return std::nullopt;
  Trunk trunk;
  trunk.hips = (body.at(legs[0]) + body.at(legs[1])) / 2.0;
  trunk.left = body.at(shoulderOf(body, arms[0], trunk.hips));
  trunk.right = body.at(shoulderOf(body, arms[1], trunk.hips));
  trunk.shoulders = (trunk.left + trunk.right) / 2.0;
  trunk.chest = body.skeleton.joints[arms[0]].parent->value;
  return trunk;
}

/// Three columns side by side from pelvis to collar, and the bars that join them: an oval, seen from above.
void addTrunk(const Anatomy& body, const Trunk& trunk, double scale, std::vector<Bone>& bones) {
  const Vec3 across = (trunk.left - trunk.right) / 2.0;
  const Vec3 up(0.0, scale, 0.0);
  const auto between = [&](double share) -> Vec3 {
    return trunk.hips + (trunk.shoulders - trunk.hips) * share;
  };
  const auto add = [&](const Vec3& from, double fromRadius, const Vec3& to, double toRadius) {
    // The lower part goes with the pelvis, the upper part with the chest.
    const auto jointAt = [&](const Vec3& p) {
      return (p - trunk.hips).y() < 0.5 * (trunk.shoulders - trunk.hips).y() ? std::size_t{0} : trunk.chest;
    };
    const std::size_t a = jointAt(from), b = jointAt(to);
    bones.push_back({JointIndex(a), JointIndex(b), offsetIn(body, a, from), offsetIn(body, b, to),
                     fromRadius * scale, toRadius * scale});
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

/// Many files end at the neck: the skull is set above the shoulders, and hangs on the last joint that turns.
void addHead(const Anatomy& body, const std::optional<Trunk>& trunk, double scale, std::vector<Bone>& bones) {
  const std::vector<std::size_t> heads = limbRoots(body, Limb::kHead);
  if (heads.empty()) return;
  std::size_t end = heads[0];
  while (!body.children[end].empty()) end = body.children[end][0];
  const bool isEnd = body.skeleton.joints[end].isEndSite;
  const std::size_t skull = isEnd ? body.skeleton.joints[end].parent->value : end;
  const std::size_t base = trunk ? trunk->chest : body.skeleton.joints[heads[0]].parent->value;
  const Vec3 up(0.0, scale, 0.0);
  const Vec3 root = trunk ? trunk->shoulders : body.at(base);
  Vec3 crown = body.at(end);
  if (crown.y() < root.y() + 0.29 * scale)
    crown = Vec3(body.at(skull).x(), root.y() + 0.29 * scale, body.at(skull).z());
  const JointIndex joint(skull);
  const Vec3 forehead = crown - 0.100 * up, chin = crown - 0.170 * up;
  bones.push_back({joint, joint, offsetIn(body, skull, forehead), offsetIn(body, skull, chin), 0.098 * scale,
                   0.076 * scale});
  bones.push_back({joint, JointIndex(base), offsetIn(body, skull, chin + 0.02 * up),
                   offsetIn(body, base, root - 0.03 * up), 0.052 * scale, 0.068 * scale});
}

/// Behind each ankle, down to the floor.
void addHeels(const Anatomy& body, double scale, std::vector<Bone>& bones) {
  for (std::size_t toe = 1; toe < body.skeleton.size(); ++toe) {
    const std::size_t ankle = body.skeleton.joints[toe].parent->value;
    if (body.limb[ankle] != Limb::kLeg || body.depthInLimb[ankle] != 2 || body.depthInLimb[toe] != 3)
      continue;
    Vec3 back = body.at(ankle) - body.at(toe);
    back.y() = 0.0;
    const double radius = 0.036 * scale;
    Vec3 heel = body.at(ankle) + 0.32 * back;
    heel.y() = std::min(body.at(ankle).y(), body.at(toe).y() + 0.012 * scale);
    const JointIndex joint(ankle);
    bones.push_back({joint, joint, Vec3::Zero(), offsetIn(body, ankle, heel), 0.041 * scale, radius});
    bones.push_back(
        {joint, JointIndex(toe), offsetIn(body, ankle, heel), Vec3::Zero(), radius, 0.037 * scale});
  }
}

}  // namespace

std::vector<Bone> bonesFor(const Skeleton& skeleton, const PoseView& standing) {
  const Anatomy body = anatomyOf(skeleton, standing);
  const std::optional<Trunk> trunk = trunkOf(body);
  const double scale = trunk ? (trunk->shoulders.y() - body.floor) / kReferenceShoulderMetres
                             : body.height() / kReferenceHeightMetres;
  std::vector<Bone> bones;
  if (trunk) addTrunk(body, *trunk, scale, bones);
  const bool hasTrunk = trunk.has_value();
  addHead(body, trunk, scale, bones);
  addHeels(body, scale, bones);
  for (std::size_t i = 1; i < skeleton.size(); ++i) {
    const std::size_t parent = skeleton.joints[i].parent->value;
    const Limb limb = body.limb[parent];
    if ((body.at(i) - body.at(parent)).norm() < 0.012 * scale) continue;
    if (limb == Limb::kHead || (limb == Limb::kTorso && hasTrunk)) continue;
    const Radii radii = radiiOf(body, parent);
    bones.push_back({JointIndex(parent), JointIndex(i), Vec3::Zero(), Vec3::Zero(), radii.from * scale,
                     radii.to * scale});
  }
  return bones;
}

std::vector<Capsule> placeBones(const std::vector<Bone>& bones, const Skeleton& skeleton,
                                const PoseView& pose) {
  std::vector<JointPlacement> placed(skeleton.size());
  placeJoints(skeleton, pose, placed);
  std::vector<Capsule> capsules;
  capsules.reserve(bones.size());
  for (const Bone& bone : bones) {
    const JointPlacement& from = placed[bone.fromJoint.value];
    const JointPlacement& to = placed[bone.toJoint.value];
    capsules.push_back({from.position + from.rotation * bone.fromOffset,
                        to.position + to.rotation * bone.toOffset, bone.fromRadius, bone.toRadius});
  }
  return capsules;
}

}  // namespace stridegraph
