#pragma once

#include <optional>

#include "graph/library.h"

namespace stridegraph {

/// Between which mean rates walks along a graph can turn that go round and round: the least and the largest
/// mean over all cycles of the graph. Positive is to the left. Empty where the graph is too large to tell in
/// some hundred milliseconds.
struct TurningReach {
  Angle leastPerSecond;
  Angle mostPerSecond;
};
std::optional<TurningReach> turningReachOf(const MotionLibrary& library);

}  // namespace stridegraph
