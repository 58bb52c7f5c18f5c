#pragma once

#include <span>
#include <vector>

#include "graph/build_report.h"
#include "graph/graph_building.h"
#include "graph/jerks.h"
#include "graph/library.h"

namespace stridegraph {

/// The graph that regions offer: all of it, and the part in which every walk goes on for ever.
struct Connection {
  std::vector<FrameTransition> transitions;
  MotionGraph whole;
  MotionGraph pruned;  ///< Empty where no walk could go on for ever.
};

/// Connects the clips of a library, which needs no graph yet; nothing plays or blends across the jerks
/// (ascending).
Connection connectionOf(const MotionLibrary& library, std::span<const Jerk> jerks,
                        std::span<const AlikeRegion> regions);

/// Makes the graph of a library that has its frames, clips and regions. Reports what pruning leaves; the
/// graph is empty when that is nothing.
void connectLibrary(MotionLibrary& library, std::span<const Jerk> jerks, BuildReport& report);

}  // namespace stridegraph
