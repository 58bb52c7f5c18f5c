#pragma once

#include "base/clock.h"
#include "state/app_state.h"

namespace stridegraph {

/// Notes that what is on screen no longer fits the plan.
void wantPlan(AppState& state);

/// Plans again if it is time to: at once when the scene rests; while something is dragged with every frame,
/// or as often as leaves half of the time to the view where plans take longer. The time of playback stays,
/// and a walk under way goes on from its present pose. Returns whether it planned.
bool planWhenDue(AppState& state, const MillisecondClock& clock);

/// Looks for a better walk for a scene that rests, for a part of a frame that takes so long, until a number
/// of states is used up; so walks do not depend on how fast the machine is. What it finds is shown as soon as
/// the body on screen does not jump for it. Returns whether another walk is shown.
bool improveWalk(AppState& state, const MillisecondClock& clock, double frameSeconds);

}  // namespace stridegraph
