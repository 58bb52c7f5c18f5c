#pragma once

#include <string>
#include <vector>

#include "motion/bvh_hierarchy.h"
#include "motion/bvh_layout.h"
#include "motion/clip.h"
#include "motion/kinematics.h"
#include "motion/position_channels.h"
#include "motion/travelling_root.h"

namespace stridegraph {

/// Where a joint of the hierarchy lies in a row, by forward kinematics from ROOT; file units and axes.
JointPlacement placementInFile(const BvhHierarchy& hierarchy, const JointTranslations& translations,
                               std::size_t joint, std::size_t frame);

/// What stands above and beside the joint that travels, as in the first row of the file.
BvhStillPart stillPartOf(const BvhHierarchy& hierarchy, const JointTranslations& translations,
                         const TravellingRoot& parts, UpAxis up, double unitsPerMetre);

/// A skeleton with its still joints, as the file has them: what a BVH file is written from.
struct WholeBvh {
  Skeleton skeleton;
  BvhLayout layout;  ///< Without a still part.
  Clip clip;
  JointIndex travelling;     ///< The skeleton's root among the joints of the whole.
  std::vector<Vec3> travel;  ///< Of that joint against its parent, frame by frame; metres, y up.
};
/// The layout must have a still part.
WholeBvh withStillPart(const Skeleton& skeleton, const BvhLayout& layout, const Clip& clip);

/// Why a still part cannot be written around a skeleton; empty when it can. Joints must come in the order of
/// a file, parents before children and children together, with finite numbers and rotations of unit length.
std::string faultIn(const BvhStillPart& still);

}  // namespace stridegraph
