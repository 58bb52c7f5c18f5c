#pragma once

#include <optional>
#include <span>
#include <vector>

#include "math/floor_transform.h"
#include "motion/clip.h"
#include "path/floor_plan.h"
#include "scene/scene.h"

namespace stridegraph {

/// How much a walk may be bent to arrive exactly.
struct ArrivalWarpParams {
  double stretch = 0.05;                     ///< Largest change of a step's length, as a share of it.
  Angle turnPerMetre = Angle::degrees(5.0);  ///< Largest added turn for each metre gone.
  double exactMetres = 0.001;                ///< Arrived exactly is within this
  Angle exactTurn = Angle::degrees(0.05);    ///< and this.
};

/// What was done to a walk.
struct ArrivalWarp {
  double metres = 0.0;   ///< Length of the walk's end that was bent; 0 when it was left as it was.
  double stretch = 0.0;  ///< Largest change of a step's length, as a share of it.
  Angle turnPerMetre;    ///< Largest added turn.
};

/// A walk's way over the floor: placements frame by frame.
struct BentWay {
  std::vector<FloorTransform> placements;
  ArrivalWarp warp;
};

/// Bends the end of a way so that its last frame stands at the goal and, where the goal has a heading, faces
/// it. What is left over is spread over the last metres as small changes of the length and turn of the steps:
/// those of least norm (weighted by the way gone, growing smoothly from where the bending begins) that make
/// up for it, by Newton's method. A body that does not move is not moved. The shortest end is bent that stays
/// within the limits and off obstacles and walls. Nothing when none does.
std::optional<BentWay> bendToGoal(std::span<const FloorTransform> way, const Placement& goal,
                                  const FloorPlan& plan, const ArrivalWarpParams& params = {});

/// Moves the roots of a walk from one way to another, frame by frame; poses keep all but the root's place and
/// heading on the floor.
void moveRoots(std::span<const FloorTransform> from, std::span<const FloorTransform> to, Clip& walk);

}  // namespace stridegraph
