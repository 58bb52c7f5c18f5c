#pragma once

#include <string>
#include <vector>

#include "math/rotation.h"
#include "motion/skeleton.h"

namespace stridegraph {

enum class BvhChannel { kXPosition, kYPosition, kZPosition, kXRotation, kYRotation, kZRotation };

/// Which way up a file's numbers are.
enum class UpAxis { kY, kZ };

/// What of a BVH file's form is not motion: enough to write a walk with the names, channels, unit and axes of
/// the clips that it came from.
struct BvhLayout {
  /// For each joint of the skeleton its channels in file order; empty for end sites.
  std::vector<std::vector<BvhChannel>> channels;
  /// For each joint of the skeleton: "End Site" names as written, usually empty.
  std::vector<std::string> endSiteNames;
  double unitsPerMetre = 100.0;  ///< File units in a metre: 100 for centimetres.
  UpAxis up = UpAxis::kY;
};

/// The plainest layout: position and zxy rotation channels at the root, zxy rotations elsewhere, centimetres,
/// y up.
BvhLayout standardBvhLayout(const Skeleton& skeleton);

}  // namespace stridegraph
