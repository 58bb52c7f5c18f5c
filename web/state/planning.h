#pragma once

#include "base/clock.h"
#include "state/app_state.h"

namespace stridegraph {

/// Notes that what is on screen no longer fits the plan.
void wantPlan(AppState& state);

/// Plans again if it is time to: at once when the scene rests; while something is dragged with every frame,
/// or as often as leaves half of the time to the view where plans take longer. The time of playback stays,
/// and a walk under way goes on from its present pose. A scene that rests is given a moment more for a better
/// walk. Returns whether it planned.
bool planWhenDue(AppState& state, const MillisecondClock& clock);

}  // namespace stridegraph
