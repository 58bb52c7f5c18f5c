#pragma once

#include <cstddef>
#include <vector>

#include "base/error.h"
#include "motion/bvh_hierarchy.h"
#include "motion/position_channels.h"

namespace stridegraph {

/// A hierarchy taken apart at the joint whose path is the body's. Indices are those of the hierarchy; each
/// list ascends.
struct TravellingRoot {
  std::size_t root = 0;             ///< The joint that travels.
  std::vector<std::size_t> above;   ///< What it hangs on, from ROOT down; empty when it is ROOT.
  std::vector<std::size_t> body;    ///< The root and all below it, contiguous in the file.
  std::vector<std::size_t> beside;  ///< All others: props, cameras, targets. End sites included.
};

/// Finds the joint that travels: the lowest joint with the whole body below it that moves against its parent,
/// or ROOT. Descends from ROOT into the largest branch while what hangs beside that is no part of the body:
/// scenery that never changes below a joint that never changes, and short branches that move on their own, as
/// targets do. Past anything it descends into a branch that goes farther than a quarter of the body's size,
/// as no part of a body does. In a motion that stands still, the first joint that position channels put
/// anywhere is the root, if all others are below it. Says in `warnings` which joint it is where it is not
/// ROOT, and what is left beside it.
TravellingRoot findTravellingRoot(const BvhHierarchy& hierarchy, const JointTranslations& translations,
                                  Warnings& warnings);

}  // namespace stridegraph
