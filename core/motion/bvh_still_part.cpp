#include "motion/bvh_still_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/check.h"
#include "motion/bvh_channels.h"
#include "motion/bvh_conventions.h"

namespace stridegraph {
namespace {

/// worldFromHolder of the still joint that the skeleton hangs on; metres, y up.
JointPlacement holderPlacement(const BvhStillPart& still) {
  std::vector<JointPlacement> placements;
  for (const BvhStillJoint& entry : still.joints) {
    if (!entry.joint.parent) {
      placements.push_back({entry.rotation, entry.joint.offset});
      continue;
    }
    const JointPlacement& parent = placements[entry.joint.parent->value];
    placements.push_back(
        {parent.rotation * entry.rotation, parent.position + parent.rotation * entry.joint.offset});
  }
  return placements[still.holder];
}

/// Where a still joint comes among the joints of the whole.
std::size_t placeInWhole(const BvhStillPart& still, std::size_t skeletonSize, std::size_t joint) {
  return joint < still.before ? joint : joint + skeletonSize;
}

void appendStill(const BvhStillPart& still, std::size_t skeletonSize, std::size_t first, std::size_t end,
                 WholeBvh& whole) {
  for (std::size_t s = first; s < end; ++s) {
    const BvhStillJoint& entry = still.joints[s];
    Joint joint = entry.joint;
    if (joint.parent) joint.parent = JointIndex(placeInWhole(still, skeletonSize, joint.parent->value));
    whole.skeleton.joints.push_back(std::move(joint));
    whole.layout.channels.push_back(entry.channels);
    whole.layout.endSiteNames.push_back(entry.endSiteName);
  }
}

void appendBody(const Skeleton& skeleton, const BvhLayout& layout, WholeBvh& whole) {
  const BvhStillPart& still = layout.still;
  for (std::size_t j = 0; j < skeleton.size(); ++j) {
    Joint joint = skeleton.joints[j];
    if (joint.parent) {
      joint.parent = JointIndex(still.before + joint.parent->value);
    } else {
      joint.parent = JointIndex(still.holder);
      joint.offset = still.rootOffset;
    }
    whole.skeleton.joints.push_back(std::move(joint));
    whole.layout.channels.push_back(layout.channels[j]);
    whole.layout.endSiteNames.push_back(layout.endSiteNames[j]);
  }
}

void appendFrames(const BvhStillPart& still, const Clip& clip, WholeBvh& whole) {
  whole.clip = {clip.name, clip.framesPerSecond, whole.skeleton.size(), {}, {}};
  const JointPlacement holder = holderPlacement(still);
  const Quat holderFromWorld = holder.rotation.conjugate();
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    const PoseView pose = clip.pose(f);
    Pose wholePose{still.joints.front().joint.offset, {}};
    for (std::size_t s = 0; s < still.before; ++s) wholePose.rotations.push_back(still.joints[s].rotation);
    wholePose.rotations.push_back(holderFromWorld * pose.rotations[0]);
    wholePose.rotations.insert(wholePose.rotations.end(), pose.rotations.begin() + 1, pose.rotations.end());
    for (std::size_t s = still.before; s < still.joints.size(); ++s)
      wholePose.rotations.push_back(still.joints[s].rotation);
    whole.clip.append(wholePose.view());
    whole.travel.push_back(holderFromWorld * (pose.rootPosition - holder.position));
  }
}

std::string faultInJoint(const BvhStillPart& still, std::size_t s) {
  const BvhStillJoint& entry = still.joints[s];
  const Joint& joint = entry.joint;
  if ((s == 0) != !joint.parent)
    return fmt::format("still joint {} is {}the file's root", s, s == 0 ? "not " : "");
  if (!joint.offset.allFinite() || !entry.rotation.coeffs().allFinite() ||
      std::abs(entry.rotation.norm() - 1.0) > 1e-3)
    return fmt::format("still joint {} has no finite offset and rotation", joint.name);
  std::vector<BvhChannel> channels = entry.channels;
  std::sort(channels.begin(), channels.end());
  if (std::adjacent_find(channels.begin(), channels.end()) != channels.end())
    return fmt::format("still joint {} has a channel twice", joint.name);
  if (!joint.parent) return joint.isEndSite ? "a still root that is an end site" : std::string();
  if (joint.parent->value >= s) return fmt::format("still joint {} comes before its parent", joint.name);
  if (still.joints[joint.parent->value].joint.isEndSite)
    return fmt::format("still joint {} hangs on an end site", joint.name);
  return {};
}

}  // namespace

JointPlacement placementInFile(const BvhHierarchy& hierarchy, const JointTranslations& translations,
                               std::size_t joint, std::size_t frame) {
  JointPlacement placement{Quat::Identity(), Vec3::Zero()};
  for (std::optional<std::size_t> j = joint; j; j = hierarchy.joints[*j].parent) {
    const Quat rotation = rotationIn(hierarchy.joints[*j], translations.row(frame));
    placement.position = translations.at(*j, frame) + rotation * placement.position;
    placement.rotation = rotation * placement.rotation;
  }
  return placement;
}

BvhStillPart stillPartOf(const BvhHierarchy& hierarchy, const JointTranslations& translations,
                         const TravellingRoot& parts, UpAxis up, double unitsPerMetre) {
  BvhStillPart still;
  if (parts.above.empty()) return still;
  std::vector<std::size_t> joints = parts.above;
  joints.insert(joints.end(), parts.beside.begin(), parts.beside.end());
  std::sort(joints.begin(), joints.end());
  const auto placeOf = [&](std::size_t j) {
    return static_cast<std::size_t>(std::lower_bound(joints.begin(), joints.end(), j) - joints.begin());
  };
  for (const std::size_t j : joints) {
    const BvhJoint& source = hierarchy.joints[j];
    Joint joint{source.name, {}, coreFromFile(up, translations.at(j, 0)) / unitsPerMetre, source.isEndSite};
    if (source.parent) joint.parent = JointIndex(placeOf(*source.parent));
    still.joints.push_back({std::move(joint), coreFromFile(up, rotationIn(source, translations.row(0))),
                            source.channels, source.endSiteName});
  }
  still.before = placeOf(parts.root);
  still.holder = placeOf(parts.above.back());
  still.rootOffset = coreFromFile(up, hierarchy.joints[parts.root].offset) / unitsPerMetre;
  return still;
}

WholeBvh withStillPart(const Skeleton& skeleton, const BvhLayout& layout, const Clip& clip) {
  const BvhStillPart& still = layout.still;
  STRIDEGRAPH_CHECK(still.holder < still.before && still.before <= still.joints.size());
  WholeBvh whole;
  whole.travelling = JointIndex(still.before);
  whole.layout.unitsPerMetre = layout.unitsPerMetre;
  whole.layout.up = layout.up;
  appendStill(still, skeleton.size(), 0, still.before, whole);
  appendBody(skeleton, layout, whole);
  appendStill(still, skeleton.size(), still.before, still.joints.size(), whole);
  appendFrames(still, clip, whole);
  return whole;
}

std::string faultIn(const BvhStillPart& still) {
  if (still.joints.empty()) return {};
  for (std::size_t s = 0; s < still.joints.size(); ++s) {
    if (std::string fault = faultInJoint(still, s); !fault.empty()) return fault;
  }
  if (still.before > still.joints.size() || still.holder >= still.before)
    return fmt::format("a skeleton behind {} of {} still joints hangs on still joint {}", still.before,
                       still.joints.size(), still.holder);
  if (still.joints[still.holder].joint.isEndSite) return "a skeleton that hangs on an end site";
  if (!still.rootOffset.allFinite()) return "an offset of the root that is not finite";
  // In the order of a file each joint hangs on one that is still open.
  std::vector<std::size_t> open;
  for (std::size_t s = 0; s < still.joints.size(); ++s) {
    const auto hangOn = [&](std::size_t parent) {
      while (!open.empty() && open.back() != parent) open.pop_back();
      return !open.empty();
    };
    if (s == still.before && !hangOn(still.holder)) return "a skeleton out of the order of a file";
    const auto& parent = still.joints[s].joint.parent;
    if (parent && !hangOn(parent->value))
      return fmt::format("still joint {} is out of the order of a file", still.joints[s].joint.name);
    open.push_back(s);
  }
  if (still.before == still.joints.size() && std::find(open.begin(), open.end(), still.holder) == open.end())
    return "a skeleton out of the order of a file";
  return {};
}

}  // namespace stridegraph
