#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "math/types.h"
#include "motion/bvh_layout.h"
#include "motion/bvh_scanner.h"

namespace stridegraph {

/// A joint as a BVH text states it: nothing is converted or folded yet.
struct BvhJoint {
  std::string name;         ///< Of an end site: its parent's with "#end", from the second on "#end2", ...
  std::string endSiteName;  ///< What an end site was called in the text beyond "End Site", usually nothing.
  std::optional<std::size_t> parent;
  bool isEndSite = false;
  Vec3 offset = Vec3::Zero();        ///< File units and axes.
  std::vector<BvhChannel> channels;  ///< In file order; each kind at most once.
  std::size_t firstColumn = 0;       ///< Where its channels begin in a row of MOTION.
};

/// The joints of a HIERARCHY in file order, parents first.
struct BvhHierarchy {
  std::vector<BvhJoint> joints;
  std::size_t columns = 0;  ///< Numbers in a row of MOTION, at least 1.
};

/// Reads HIERARCHY up to the brace that closes ROOT. Whatever follows "End" begins an end site: exporters
/// write "End Site", "End Site1" or "End tip". Fails with kBvhSyntax where the text breaks the grammar: each
/// joint has a name, one OFFSET and at most one CHANNELS, both before its children; end sites have an OFFSET
/// alone. Fails with kBvhValue beyond the limits of motion/bvh_limits.h.
Result<BvhHierarchy> parseBvhHierarchy(BvhScanner& scanner);

}  // namespace stridegraph
