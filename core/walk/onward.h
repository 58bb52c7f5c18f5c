#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "walk/motion_search.h"
#include "walk/plan.h"

namespace stridegraph {

/// Where a walk under way turns off into a new one.
struct TurnOff {
  Onward onward;                ///< The decision node, where the walk has it, and when.
  std::vector<WalkStep> steps;  ///< Of the walk, until there.
};

/// The first decision node that a walk comes to after a frame; nothing when there is none left, which is so
/// in its last steps.
std::optional<TurnOff> turnOff(const SearchGraph& graph, const Plan& walk, std::size_t frame);

/// The steps of a walk until it turns off, and those found for what is left of it, as one path.
MotionPath joined(std::vector<WalkStep> steps, const MotionPath& rest, const FloorTransform& start);

/// A way as it was until a frame, and from that frame on another.
std::vector<FloorTransform> replaced(std::span<const FloorTransform> way, std::size_t frame,
                                     std::span<const FloorTransform> rest);

/// Shows the one walk until a frame and leads over to the other within a third of a second. Their poses
/// differ there by no more than how feet were corrected, so the eye sees no seam.
void fadeFrom(const Clip& before, std::size_t frame, Clip& walk);

}  // namespace stridegraph
