#pragma once

#include "walk/standing_body.h"
#include "walk/step_plan.h"
#include "walk/synthesis.h"

namespace stridegraph {

/// How steps look. Times in seconds.
struct SteppedWalkParams {
  double stepSeconds = 0.52;       ///< Of a step on the spot,
  double perMetreSeconds = 0.3;    ///< for each metre that the foot goes,
  double perRadianSeconds = 0.15;  ///< and for each radian that it turns.
  double swingShare = 0.74;        ///< Of a step, how much of it one foot is in the air.
  double restSeconds = 0.3;        ///< Standing before the first and after the last step.
  double liftMetres = 0.045;       ///< Of the ball of the foot, on the spot,
  double liftPerMetre = 0.035;     ///< and for each metre that the foot goes.
  double swayMetres = 0.022;       ///< Of the hips over the foot that stands; 0 keeps to the straight line.
  Angle heelRise = Angle::degrees(26.0);  ///< Largest, in a long step ahead.
};

/// A walk of small steps: the body stands as in the library, its hips go from foot to foot, and legs are
/// solved in closed form (solveLeg), so planted feet do not move at all. The first and the last frames stand.
/// The upper body moves as in a captured walk, the more the longer the steps ahead are. The heel rises before
/// a foot goes ahead, while the foot rolls over its ball.
SynthesisedWalk stepWalk(const MotionLibrary& library, const StandingBody& body, const StepPlan& plan,
                         const SteppedWalkParams& params = {});

}  // namespace stridegraph
