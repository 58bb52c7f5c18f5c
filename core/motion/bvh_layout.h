#pragma once

#include <string>
#include <vector>

#include "math/rotation.h"
#include "motion/skeleton.h"

namespace stridegraph {

enum class BvhChannel { kXPosition, kYPosition, kZPosition, kXRotation, kYRotation, kZRotation };

/// Which way up a file's numbers are.
enum class UpAxis { kY, kZ };

/// A joint of a BVH file that is no part of the body and keeps its place.
struct BvhStillJoint {
  Joint
      joint;  ///< As it stands: metres, y up. Its parent is a still joint, too; the first is the file's ROOT.
  Quat rotation = Quat::Identity();  ///< Relative to its parent.
  std::vector<BvhChannel> channels;
  std::string endSiteName;
};

/// The joints of a file that do not travel, where the skeleton's root is not the file's ROOT: what stands
/// above it, and what hangs beside it.
struct BvhStillPart {
  std::vector<BvhStillJoint> joints;  ///< In file order; empty when the skeleton's root is the file's ROOT.
  std::size_t before = 0;             ///< How many of them come before the skeleton; 1 or more.
  std::size_t holder = 0;             ///< The one that the skeleton's root hangs on, less than `before`.
  Vec3 rootOffset = Vec3::Zero();     ///< OFFSET of the skeleton's root; metres, y up.
};

/// What of a BVH file's form is not motion: enough to write a walk with the names, channels, unit and axes of
/// the clips that it came from.
struct BvhLayout {
  /// For each joint of the skeleton its channels in file order; empty for end sites.
  std::vector<std::vector<BvhChannel>> channels;
  /// For each joint of the skeleton: "End Site" names as written, usually empty.
  std::vector<std::string> endSiteNames;
  double unitsPerMetre = 100.0;  ///< File units in a metre: 100 for centimetres.
  UpAxis up = UpAxis::kY;
  BvhStillPart still = {};
};

/// The plainest layout: position and zxy rotation channels at the root, zxy rotations elsewhere, centimetres,
/// y up.
BvhLayout standardBvhLayout(const Skeleton& skeleton);

}  // namespace stridegraph
