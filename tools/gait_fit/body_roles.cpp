#include "gait_fit/body_roles.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "motion/contacts.h"
#include "motion/kinematics.h"
#include "motion/mirror_map.h"

namespace stridegraph::gait_fit {
namespace {

/// Three joints of one limb: hip, knee, ankle or shoulder, elbow, wrist; how high its far end lies.
struct Limb {
  std::array<std::size_t, 3> joints;
  double lowest;
  double highest;
};

double boneLength(const Skeleton& skeleton, std::size_t joint) {
  return skeleton.joints[joint].offset.norm();
}

/// The way down from a joint that is longest in metres.
std::vector<std::size_t> longestWay(const Skeleton& skeleton, std::size_t from) {
  std::vector<std::size_t> longest;
  double reach = -1.0;
  for (const JointIndex child : skeleton.childrenOf(JointIndex(from))) {
    std::vector<std::size_t> way = longestWay(skeleton, child.value);
    double length = 0.0;
    for (const std::size_t joint : way) length += boneLength(skeleton, joint);
    if (length <= reach) continue;
    reach = length;
    longest = std::move(way);
  }
  longest.insert(longest.begin(), from);
  return longest;
}

/// A chain's two longest bones in a row; nothing when it has none.
std::optional<Limb> limbAlong(const Skeleton& skeleton, std::size_t from, const std::vector<double>& levels) {
  const std::vector<std::size_t> way = longestWay(skeleton, from);
  std::optional<Limb> limb;
  double best = 1e-6;
  for (std::size_t i = 0; i + 2 < way.size(); ++i) {
    const double shorter = std::min(boneLength(skeleton, way[i + 1]), boneLength(skeleton, way[i + 2]));
    if (skeleton.joints[way[i + 2]].isEndSite || shorter <= best) continue;
    best = shorter;
    limb = Limb{{way[i], way[i + 1], way[i + 2]}, levels[way.back()], levels[way[i]]};
  }
  return limb;
}

/// The first limb of each pair that hangs on the body's middle.
std::vector<Limb> limbsOf(const Skeleton& skeleton, const MirrorMap& map, const std::vector<double>& levels) {
  std::vector<Limb> limbs;
  for (std::size_t j = 1; j < skeleton.size(); ++j) {
    const JointIndex parent = *skeleton.joints[j].parent;
    if (map.partner[parent.value] != parent || map.partner[j].value <= j) continue;
    if (const auto limb = limbAlong(skeleton, j, levels)) limbs.push_back(*limb);
  }
  return limbs;
}

/// True when `joint` lies on the left of its partner as the body goes.
bool isLeft(const Skeleton& skeleton, std::span<const Clip> clips, std::size_t joint, std::size_t partner) {
  double left = 0.0;
  for (const Clip& clip : clips)
    for (std::size_t f = 0; f < clip.frameCount(); ++f) {
      const Vec2 travel = travelAt(clip, f);
      const auto points = jointPositions(skeleton, clip.pose(f));
      const Vec2 apart = onFloor(points[joint]) - onFloor(points[partner]);
      left += apart.x() * travel.y() - apart.y() * travel.x();
    }
  return left > 0.0;
}

void assign(BodyRoles& roles, StoredJoint role, std::size_t left, std::size_t right) {
  roles.left[static_cast<std::size_t>(role)] = JointIndex(left);
  roles.right[static_cast<std::size_t>(role)] = JointIndex(right);
}

/// The middle joint that carries a limb.
std::size_t carrierOf(const Skeleton& skeleton, const MirrorMap& map, std::size_t joint) {
  while (map.partner[joint].value != joint) joint = skeleton.joints[joint].parent->value;
  return joint;
}

/// The last joint of the longest middle chain above the one that carries the arms; that itself without one.
std::size_t headAbove(const Skeleton& skeleton, const MirrorMap& map, std::size_t thorax) {
  std::size_t head = thorax;
  for (std::size_t j = thorax + 1; j < skeleton.size(); ++j) {
    const bool isMiddle = map.partner[j].value == j && !skeleton.joints[j].isEndSite;
    if (isMiddle && skeleton.joints[j].parent->value == head) head = j;
  }
  return head;
}

}  // namespace

Vec2 travelAt(const Clip& clip, std::size_t frame) {
  constexpr double kHalfSeconds = 0.1;
  constexpr double kSlowest = 0.3;
  const auto reach = static_cast<std::size_t>(kHalfSeconds * clip.framesPerSecond) + 1;
  const std::size_t before = frame - std::min(frame, reach);
  const std::size_t after = std::min(frame + reach, clip.frameCount() - 1);
  const Vec2 way = onFloor(clip.rootPositions[after]) - onFloor(clip.rootPositions[before]);
  const double seconds = static_cast<double>(after - before) / clip.framesPerSecond;
  return way.norm() < kSlowest * seconds || after == before ? Vec2(Vec2::Zero()) : Vec2(way.normalized());
}

Result<BodyRoles> findBodyRoles(const Skeleton& skeleton, std::span<const Clip> clips) {
  Result<MirrorMap> map = findMirrorMap(skeleton, clips);
  if (!map) return fail(ErrorCode::kSkeletonMismatch, map.error().message);
  const std::vector<double> levels = jointLevelsMetres(skeleton, clips.front());
  std::vector<Limb> limbs = limbsOf(skeleton, *map, levels);
  if (limbs.empty())
    return fail(ErrorCode::kSkeletonMismatch,
                "found no pair of legs, expected two limbs of hip, knee and ankle that are mirror images");
  const auto legs = std::min_element(limbs.begin(), limbs.end(),
                                     [](const Limb& a, const Limb& b) { return a.lowest < b.lowest; });
  const Limb leg = *legs;
  limbs.erase(legs);
  if (limbs.empty())
    return fail(
        ErrorCode::kSkeletonMismatch,
        "found no pair of arms, expected two limbs of shoulder, elbow and wrist that are mirror images");
  const Limb arm = *std::max_element(limbs.begin(), limbs.end(),
                                     [](const Limb& a, const Limb& b) { return a.highest < b.highest; });
  BodyRoles roles;
  assign(roles, StoredJoint::kPelvis, 0, 0);
  const std::size_t thorax = carrierOf(skeleton, *map, arm.joints[0]);
  const std::size_t head = headAbove(skeleton, *map, thorax);
  assign(roles, StoredJoint::kThorax, thorax, thorax);
  assign(roles, StoredJoint::kHead, head, head);
  constexpr std::array kLegRoles = {StoredJoint::kFemur, StoredJoint::kTibia, StoredJoint::kFoot};
  constexpr std::array kArmRoles = {StoredJoint::kHumerus, StoredJoint::kRadius, StoredJoint::kHand};
  for (const auto& [limb, rolesOfLimb] : {std::pair{leg, kLegRoles}, std::pair{arm, kArmRoles}})
    for (std::size_t k = 0; k < limb.joints.size(); ++k) {
      std::size_t left = limb.joints[k];
      std::size_t right = map->partner[left].value;
      if (!isLeft(skeleton, clips, limb.joints[0], map->partner[limb.joints[0]].value))
        std::swap(left, right);
      assign(roles, rolesOfLimb[k], left, right);
    }
  return roles;
}

}  // namespace stridegraph::gait_fit
