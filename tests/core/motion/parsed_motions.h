#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "math/rotation.h"
#include "motion/bvh_hierarchy.h"
#include "motion/bvh_motion.h"
#include "motion/kinematics.h"

namespace stridegraph::testing {

inline const std::vector<BvhChannel> kSixChannels = {BvhChannel::kXPosition, BvhChannel::kYPosition,
                                                     BvhChannel::kZPosition, BvhChannel::kZRotation,
                                                     BvhChannel::kXRotation, BvhChannel::kYRotation};
inline const std::vector<BvhChannel> kRotationChannels = {BvhChannel::kZRotation, BvhChannel::kXRotation,
                                                          BvhChannel::kYRotation};

/// A hierarchy and its motion as the parser leaves them, put together joint by joint.
struct ParsedBvh {
  BvhHierarchy hierarchy;
  BvhMotion motion;

  /// Joints come in file order; the parent is named by its index.
  std::size_t addJoint(std::string name, std::optional<std::size_t> parent, const Vec3& offset,
                       std::vector<BvhChannel> channels) {
    BvhJoint joint;
    joint.name = std::move(name);
    joint.parent = parent;
    joint.offset = offset;
    joint.channels = std::move(channels);
    joint.firstColumn = hierarchy.columns;
    hierarchy.columns += joint.channels.size();
    hierarchy.joints.push_back(std::move(joint));
    return hierarchy.joints.size() - 1;
  }

  std::size_t addEndSite(std::size_t parent, const Vec3& offset) {
    const std::size_t j = addJoint(hierarchy.joints[parent].name + "#end", parent, offset, {});
    hierarchy.joints[j].isEndSite = true;
    return j;
  }

  /// Rows of zeros, once all joints are there.
  void setFrames(std::size_t count) {
    motion.frameCount = count;
    motion.columns = hierarchy.columns;
    motion.values.assign(count * motion.columns, 0.0);
  }

  /// Sets what of a joint's place at its parent its channels can say; the rotation channels are zxy.
  void place(std::size_t j, std::size_t frame, const Vec3& position, const Quat& rotation) {
    const BvhJoint& joint = hierarchy.joints[j];
    const std::array<Angle, 3> angles = toEuler({Axis::kZ, Axis::kX, Axis::kY}, rotation);
    double* const values = &motion.values[frame * motion.columns + joint.firstColumn];
    std::size_t angle = 0;
    for (std::size_t c = 0; c < joint.channels.size(); ++c) {
      const BvhChannel channel = joint.channels[c];
      values[c] = channel <= BvhChannel::kZPosition ? position[static_cast<Eigen::Index>(channel)]
                                                    : angles[angle++].degrees();
    }
  }
};

/// Adds a skeleton below `parent` and its clip: six channels at its root, of which `rootAt(frame)` says the
/// place at `parent`, rotations elsewhere. Lengths are multiplied by `unitsPerMetre`.
template <typename RootAt>
void addBody(ParsedBvh& parsed, const Skeleton& skeleton, const Clip& clip, std::optional<std::size_t> parent,
             double unitsPerMetre, RootAt rootAt) {
  const std::size_t first = parsed.hierarchy.joints.size();
  for (const Joint& joint : skeleton.joints) {
    if (joint.isEndSite) {
      parsed.addEndSite(first + joint.parent->value, joint.offset * unitsPerMetre);
    } else {
      parsed.addJoint(joint.name,
                      joint.parent ? std::optional<std::size_t>(first + joint.parent->value) : parent,
                      joint.offset * unitsPerMetre, joint.parent ? kRotationChannels : kSixChannels);
    }
  }
  parsed.setFrames(clip.frameCount());
  parsed.motion.framesPerSecond = clip.framesPerSecond;
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    const JointPlacement root = rootAt(f);
    for (std::size_t j = 0; j < skeleton.size(); ++j) {
      parsed.place(first + j, f, j == 0 ? Vec3(root.position * unitsPerMetre) : Vec3::Zero(),
                   j == 0 ? root.rotation : clip.pose(f).rotations[j]);
    }
  }
}

/// The place of a clip's root in the world.
inline JointPlacement rootOf(const Clip& clip, std::size_t frame) {
  const PoseView pose = clip.pose(frame);
  return {pose.rotations[0], pose.rootPosition};
}

/// Where `world` lies in the axes of `parent`.
inline JointPlacement relativeTo(const JointPlacement& parent, const JointPlacement& world) {
  const Quat parentFromWorld = parent.rotation.conjugate();
  return {parentFromWorld * world.rotation, parentFromWorld * (world.position - parent.position)};
}

}  // namespace stridegraph::testing
