#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "walk/plan.h"

namespace stridegraph {

/// A frame of a walk worth a look: where it is worst in some way.
struct WalkMark {
  std::size_t frame = 0;
  std::string name;      ///< Of the figure.
  std::string value;     ///< With its unit.
  std::string where;     ///< A sentence for a tooltip.
  bool problem = false;  ///< Worse than a walk should be.
};

/// The worst places of a walk that arrived: the fastest and the hardest driven joint against what the clips
/// do, and the dearest seam.
std::vector<WalkMark> walkMarks(const PlanReport& report);

}  // namespace stridegraph
