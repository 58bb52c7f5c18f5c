#include "motion/body_soles.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "math/percentile.h"

namespace stridegraph {
namespace {

constexpr double kAnkleRadiusMetres = 0.041, kHeelRadiusMetres = 0.036, kBallRadiusMetres = 0.037;
/// Of the heights of a point: single frames may dip lower.
constexpr double kDownShare = 0.02;
/// Of the frames, in which a foot is down for certain: bodies that run are in the air for half of the time.
constexpr double kPlantedShare = 0.4;
/// How far behind the ankle the heel may lie, as shares of the level way from the ball of the foot to it.
constexpr std::array<double, 9> kHeelShares = {0.44, 0.41, 0.38, 0.35, 0.32, 0.29, 0.26, 0.23, 0.20};
/// A heel that dips deeper than it stands in the flat foot lies too far back.
constexpr double kHeelDipMetres = 0.002;
constexpr double kThinnestSole = 0.5, kThickestSole = 1.5;  ///< Times the radius of the standard body.
constexpr double kThickestRest = 2.0;  ///< Likewise, with what is made up for on the whole.
constexpr int kAnkleDepth = 2;         ///< Below the hip.

/// Where some joints are in the poses that stand for the body's motion.
class SampledJoints {
 public:
  SampledJoints(const BodyAnatomy& body, std::span<const JointIndex> joints)
      : chains_(body.skeleton, joints) {
    for (const Pose& pose : body.samples) chains_.place(pose.view(), poses_.emplace_back(chains_.size()));
  }

  std::size_t count() const { return poses_.size(); }
  Vec3 point(std::size_t sample, JointIndex joint, const Vec3& offset = Vec3::Zero()) const {
    const JointPlacement& placed = poses_[sample][chains_.slotOf(joint)];
    return placed.position + placed.rotation * offset;
  }
  Vec3 offsetIn(std::size_t sample, JointIndex joint, const Vec3& point) const {
    const JointPlacement& placed = poses_[sample][chains_.slotOf(joint)];
    return placed.rotation.conjugate() * (point - placed.position);
  }
  /// How high a point that hangs on a joint is when it is down.
  double downMetres(JointIndex joint, const Vec3& offset) const {
    std::vector<double> heights;
    for (std::size_t i = 0; i < poses_.size(); ++i) heights.push_back(point(i, joint, offset).y());
    return percentile(std::move(heights), kDownShare);
  }

 private:
  JointChains chains_;
  std::vector<std::vector<JointPlacement>> poses_;
};

/// The heel in the ankle's axes.
Vec3 heelOf(const SampledJoints& foot, JointIndex ankle, JointIndex ball, double radius) {
  // Where the foot lies flattest.
  std::size_t flat = 0;
  const auto lowness = [&](std::size_t i) { return foot.point(i, ankle).y() + foot.point(i, ball).y(); };
  for (std::size_t i = 1; i < foot.count(); ++i)
    if (lowness(i) < lowness(flat)) flat = i;
  const Vec3 above = foot.point(flat, ankle);
  Vec3 back = above - foot.point(flat, ball);
  back.y() = 0.0;
  Vec3 heel = Vec3::Zero();
  for (const double share : kHeelShares) {
    Vec3 point = above + share * back;
    point.y() = std::min(above.y(), radius);
    heel = foot.offsetIn(flat, ankle, point);
    if (foot.downMetres(ankle, heel) >= point.y() - kHeelDipMetres) break;
  }
  return heel;
}

void addHeel(const BodyAnatomy& body, std::size_t ankle, std::size_t ball, double scale,
             std::vector<BodyPart>& parts) {
  const JointIndex joint(ankle);
  const std::array<JointIndex, 2> foot = {joint, JointIndex(ball)};
  const double radius = kHeelRadiusMetres * scale;
  const PartEnd heel{joint, heelOf(SampledJoints(body, foot), joint, foot[1], radius), radius};
  parts.push_back({{joint, Vec3::Zero(), kAnkleRadiusMetres * scale}, heel});
  parts.push_back({heel, {joint, body.skeleton.joints[ball].offset, kBallRadiusMetres * scale}});
}

/// How far the lowest of the parts' ends lies over the floor in the frames in which a foot is down.
double heightOver(const SampledJoints& legs, const BodyAnatomy& body, const std::vector<BodyPart>& parts) {
  std::vector<double> lowest(legs.count(), std::numeric_limits<double>::max());
  for (const BodyPart& part : parts) {
    if (body.limb[part.from.joint.value] != Limb::kLeg) continue;
    for (const PartEnd* const end : {&part.from, &part.to})
      for (std::size_t i = 0; i < lowest.size(); ++i)
        lowest[i] = std::min(lowest[i], legs.point(i, end->joint, end->offset).y() - end->radius);
  }
  return percentile(std::move(lowest), kPlantedShare);
}

bool isFoot(const BodyAnatomy& body, std::size_t joint) {
  return body.limb[joint] == Limb::kLeg && body.depthInLimb[joint] >= kAnkleDepth;
}

/// Whether a leg ends there, without a foot.
bool isLegsEnd(const BodyAnatomy& body, const PartEnd& end) {
  const std::vector<std::size_t>& children = body.children[end.joint.value];
  return std::any_of(children.begin(), children.end(), [&](std::size_t child) {
    return body.children[child].empty() && body.skeleton.joints[child].offset == end.offset;
  });
}

bool isSole(const BodyAnatomy& body, const PartEnd& end) {
  const std::size_t joint = end.joint.value;
  const bool isAnkle = end.offset == Vec3::Zero() && body.depthInLimb[joint] == kAnkleDepth;
  return (isFoot(body, joint) && !isAnkle) || isLegsEnd(body, end);
}

void fitEnd(const BodyAnatomy& body, const SampledJoints& legs, PartEnd& end) {
  const double thickest = isSole(body, end) ? kThickestSole : 1.0;
  end.radius =
      std::clamp(legs.downMetres(end.joint, end.offset), kThinnestSole * end.radius, thickest * end.radius);
}

void addToSole(const BodyAnatomy& body, double metres, const PartEnd& standard, PartEnd& end) {
  if (!isSole(body, end)) return;
  end.radius =
      std::clamp(end.radius + metres, kThinnestSole * standard.radius, kThickestRest * standard.radius);
}

}  // namespace

void addHeels(const BodyAnatomy& body, double scale, std::vector<BodyPart>& parts) {
  for (std::size_t ankle = 1; ankle < body.skeleton.size(); ++ankle) {
    if (body.limb[ankle] != Limb::kLeg || body.depthInLimb[ankle] != kAnkleDepth) continue;
    const std::vector<std::size_t>& below = body.children[ankle];
    const auto ball = std::find_if(below.begin(), below.end(), [&](std::size_t child) {
      return body.depthInLimb[child] == kAnkleDepth + 1;
    });
    if (ball != below.end()) addHeel(body, ankle, *ball, scale, parts);
  }
}

void fitSoles(const BodyAnatomy& body, std::vector<BodyPart>& parts) {
  std::vector<JointIndex> joints;
  for (std::size_t j = 0; j < body.skeleton.size(); ++j)
    if (body.limb[j] == Limb::kLeg) joints.emplace_back(j);
  if (joints.empty()) return;
  const SampledJoints legs(body, joints);
  const std::vector<BodyPart> standard = parts;
  for (BodyPart& part : parts) {
    if (body.limb[part.from.joint.value] != Limb::kLeg) continue;
    fitEnd(body, legs, part.from);
    fitEnd(body, legs, part.to);
  }
  // Captured feet rest at slightly different heights. All legs together take up the mean difference.
  const double rest = heightOver(legs, body, parts);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (body.limb[parts[i].from.joint.value] != Limb::kLeg) continue;
    addToSole(body, rest, standard[i].from, parts[i].from);
    addToSole(body, rest, standard[i].to, parts[i].to);
  }
}

}  // namespace stridegraph
