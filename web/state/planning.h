#pragma once

#include "base/clock.h"
#include "state/app_state.h"

namespace stridegraph {

/// Notes that what is on screen no longer fits the plan.
void wantPlan(AppState& state);

/// Plans again if it is time to: at once when the scene rests, and while it is being dragged only as often as
/// keeps the view fluent. Returns whether it planned.
bool planWhenDue(AppState& state, const MillisecondClock& clock);

}  // namespace stridegraph
