#include "motion/body_anatomy.h"

#include <algorithm>

#include "base/check.h"
#include "math/percentile.h"

namespace stridegraph {
namespace {

constexpr std::size_t kMostSamples = 2000;
constexpr std::size_t kMostSampledJoints = 1'000'000;
/// The first frame stands unless some other one holds the root this much higher, as a share of that.
constexpr double kStandingShare = 0.85;
constexpr double kKneeShare = 0.2;        ///< Of the height: legs come below, hands do not.
constexpr double kHeadReachShare = 0.25;  ///< Of the height: chains of a head are shorter, arms are longer.
constexpr double kLongBoneShare = 0.02;   ///< Of the height: shorter bones join twist joints.
/// How high toe joints lie over the floor, as shares of the height: usual, and the least and most that soles
/// can make up for.
constexpr double kToeShare = 0.02, kLowestToeShare = 0.008, kHighestToeShare = 0.03;
/// Of the frames, in which a foot is down: bodies that run are in the air for half of the time.
constexpr double kDownShare = 0.3;

/// No joint turned, the lowest as high over the floor as toes are.
Pose restPoseOf(const Skeleton& skeleton) {
  Pose pose{Vec3::Zero(), std::vector<Quat>(skeleton.size(), Quat::Identity())};
  double lowest = 0.0;
  double highest = 0.0;
  for (const Vec3& joint : jointPositions(skeleton, pose.view())) {
    lowest = std::min(lowest, joint.y());
    highest = std::max(highest, joint.y());
  }
  pose.rootPosition.y() = kToeShare * (highest - lowest) - lowest;
  return pose;
}

/// Frames that stand for a clip: evenly spread, both ends included; fewer for skeletons of many joints.
std::vector<std::size_t> sampledFrames(const Clip& frames) {
  const std::size_t all = frames.frameCount();
  const std::size_t affordable = std::max<std::size_t>(1, kMostSampledJoints / frames.jointCount);
  const std::size_t count = std::min({all, kMostSamples, affordable});
  std::vector<std::size_t> sampled;
  for (std::size_t i = 0; i < count; ++i) sampled.push_back(count == 1 ? 0 : i * (all - 1) / (count - 1));
  return sampled;
}

Pose copyOf(const PoseView& pose) {
  Pose copy{pose.rootPosition, {}};
  for (const Quat& rotation : pose.rotations) copy.rotations.push_back(rotation.normalized());
  return copy;
}

double lowestOf(const std::vector<JointPlacement>& placed) {
  double lowest = placed[0].position.y();
  for (const JointPlacement& joint : placed) lowest = std::min(lowest, joint.position.y());
  return lowest;
}

/// Joint by joint the heights over the frame's lowest joint, one for each sampled frame.
std::vector<std::vector<double>> heightsOf(const Skeleton& skeleton, const std::vector<Pose>& poses) {
  std::vector<std::vector<double>> heights(skeleton.size());
  std::vector<JointPlacement> placed(skeleton.size());
  for (const Pose& pose : poses) {
    placeJoints(skeleton, pose.view(), placed);
    const double lowest = lowestOf(placed);
    for (std::size_t j = 0; j < skeleton.size(); ++j) heights[j].push_back(placed[j].position.y() - lowest);
  }
  return heights;
}

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Of the sampled poses the first, unless its root is far lower over the feet than in another.
std::size_t standingAmong(const std::vector<double>& rootHeights) {
  const auto highest = std::max_element(rootHeights.begin(), rootHeights.end());
  if (rootHeights.front() >= kStandingShare * *highest) return 0;
  return static_cast<std::size_t>(highest - rootHeights.begin());
}

/// Of everything that hangs on each joint, itself included.
struct Extents {
  std::vector<double> lowest, highest;
  std::vector<std::size_t> ends;
};

Extents extentsOf(const BodyAnatomy& body) {
  const std::size_t count = body.skeleton.size();
  Extents extents{body.heights, body.heights, std::vector<std::size_t>(count, 0)};
  for (std::size_t j = count; j-- > 0;) {
    if (body.children[j].empty()) extents.ends[j] = 1;
    for (const std::size_t child : body.children[j]) {
      extents.lowest[j] = std::min(extents.lowest[j], extents.lowest[child]);
      extents.highest[j] = std::max(extents.highest[j], extents.highest[child]);
      extents.ends[j] += extents.ends[child];
    }
  }
  return extents;
}

/// What a joint that hangs on the trunk begins. The branch with the head goes on as trunk while it carries
/// more than the head itself.
Limb limbAt(const BodyAnatomy& body, const Extents& extents, std::size_t joint) {
  if (extents.lowest[joint] < extents.lowest[0] + kKneeShare * body.heightMetres) return Limb::kLeg;
  if (extents.highest[joint] < extents.highest[0]) return Limb::kArm;
  const bool isHead = extents.ends[joint] <= 1 || body.reach[joint] <= kHeadReachShare * body.heightMetres;
  return isHead ? Limb::kHead : Limb::kTorso;
}

/// Parents come before children, so that one pass suffices.
void divide(BodyAnatomy& body) {
  const Extents extents = extentsOf(body);
  for (std::size_t j = 1; j < body.skeleton.size(); ++j) {
    const std::size_t parent = body.skeleton.joints[j].parent->value;
    if (body.limb[parent] == Limb::kTorso) {
      body.limb[j] = limbAt(body, extents, j);
      continue;
    }
    body.limb[j] = body.limb[parent];
    const bool isLong = (body.at(j) - body.at(parent)).norm() > kLongBoneShare * body.heightMetres;
    body.depthInLimb[j] = body.depthInLimb[parent] + (isLong ? 1 : 0);
  }
}

/// Of a leg the joint below its thigh: thigh and shin are the two longest bones in a row.
std::size_t kneeOf(const BodyAnatomy& body, std::size_t root) {
  std::size_t knee = root;
  double longest = 0.0;
  for (std::size_t joint = root; !body.children[joint].empty();) {
    const std::vector<std::size_t>& children = body.children[joint];
    const auto farther = [&](std::size_t a, std::size_t b) {
      return body.boneMetres(a) + body.reach[a] < body.boneMetres(b) + body.reach[b];
    };
    const std::size_t next = *std::max_element(children.begin(), children.end(), farther);
    const double both = std::min(body.boneMetres(joint), body.boneMetres(next));
    if (joint != root && both > longest) {
      longest = both;
      knee = joint;
    }
    joint = next;
  }
  return knee;
}

/// Lets every leg begin at its hip: joints between the trunk and the hip are as deep as the hip.
void alignLegs(BodyAnatomy& body) {
  std::vector<int> above(body.skeleton.size(), 0);
  for (const std::size_t root : body.rootsOf(Limb::kLeg)) {
    const std::size_t knee = kneeOf(body, root);
    if (knee != root) above[root] = body.depthInLimb[knee] - 1;
  }
  for (std::size_t j = 1; j < body.skeleton.size(); ++j) {
    if (body.limb[j] != Limb::kLeg) continue;
    const std::size_t parent = body.skeleton.joints[j].parent->value;
    if (body.limb[parent] == Limb::kLeg) above[j] = above[parent];
    body.depthInLimb[j] = std::max(0, body.depthInLimb[j] - above[j]);
  }
}

void linkJoints(BodyAnatomy& body) {
  const std::vector<Joint>& joints = body.skeleton.joints;
  for (std::size_t j = 1; j < joints.size(); ++j) body.children[joints[j].parent->value].push_back(j);
  for (std::size_t j = joints.size(); j-- > 1;) {
    double& reach = body.reach[joints[j].parent->value];
    reach = std::max(reach, body.reach[j] + body.boneMetres(j));
  }
}

/// Raises everything, so that the lowest joints lie as high over the floor as those of feet.
void standOnFloor(BodyAnatomy& body) {
  if (body.rootsOf(Limb::kLeg).empty()) return;
  std::vector<double> lowest;
  std::vector<JointPlacement> placed(body.skeleton.size());
  for (const Pose& pose : body.samples) {
    placeJoints(body.skeleton, pose.view(), placed);
    lowest.push_back(lowestOf(placed));
  }
  const double level = percentile(std::move(lowest), kDownShare);
  const double share = level / body.heightMetres;
  if (share >= kLowestToeShare && share <= kHighestToeShare) return;
  body.liftMetres = kToeShare * body.heightMetres - level;
  for (Pose& pose : body.samples) pose.rootPosition.y() += body.liftMetres;
  for (JointPlacement& joint : body.placed) joint.position.y() += body.liftMetres;
  body.standing.rootPosition.y() += body.liftMetres;
  body.floorMetres += body.liftMetres;
}

}  // namespace

std::vector<std::size_t> BodyAnatomy::rootsOf(Limb kind) const {
  std::vector<std::size_t> roots;
  for (std::size_t j = 1; j < skeleton.size(); ++j)
    if (limb[j] == kind && limb[skeleton.joints[j].parent->value] != kind) roots.push_back(j);
  return roots;
}

std::vector<std::size_t> BodyAnatomy::mainRootsOf(Limb kind) const {
  std::vector<std::size_t> roots = rootsOf(kind);
  std::stable_sort(roots.begin(), roots.end(),
                   [&](std::size_t a, std::size_t b) { return reach[a] > reach[b]; });
  roots.resize(std::min<std::size_t>(roots.size(), 2));
  std::sort(roots.begin(), roots.end());
  return roots;
}

BodyAnatomy bodyAnatomy(const Skeleton& skeleton, const Clip& frames) {
  STRIDEGRAPH_CHECK(!skeleton.joints.empty());
  std::vector<Pose> poses;
  for (const std::size_t frame : sampledFrames(frames)) poses.push_back(copyOf(frames.pose(frame)));
  if (poses.empty()) poses.push_back(restPoseOf(skeleton));
  const std::vector<std::vector<double>> heights = heightsOf(skeleton, poses);
  const std::size_t count = skeleton.size();
  BodyAnatomy body{.skeleton = skeleton, .standing = poses[standingAmong(heights[0])]};
  body.samples = std::move(poses);
  body.standing.rootPosition.x() = body.standing.rootPosition.z() = 0.0;
  body.placed.resize(count);
  placeJoints(skeleton, body.standing.view(), body.placed);
  body.children.resize(count);
  body.reach.assign(count, 0.0);
  body.limb.assign(count, Limb::kTorso);
  body.depthInLimb.assign(count, 0);
  for (const std::vector<double>& track : heights) body.heights.push_back(medianOf(track));
  linkJoints(body);
  const auto [lowest, highest] = std::minmax_element(
      body.placed.begin(), body.placed.end(),
      [](const JointPlacement& a, const JointPlacement& b) { return a.position.y() < b.position.y(); });
  body.floorMetres = lowest->position.y();
  body.heightMetres = std::max(highest->position.y() - body.floorMetres, 0.3);
  divide(body);
  alignLegs(body);
  standOnFloor(body);
  return body;
}

}  // namespace stridegraph
