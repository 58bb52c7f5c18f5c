#pragma once

#include "state/app_state.h"

namespace stridegraph {

/// Lets time pass: moves the playhead, repeats or stops at the end. Returns whether it moved.
bool advance(AppState& state, double deltaSeconds);

/// Playback after the play button: pauses, goes on, or starts again from the end.
Playback playToggled(const AppState& state);

/// The pose on screen: the walk between two of its frames; without a walk the library's first pose, standing
/// at the start. Empty without a library.
std::optional<Pose> shownPose(const AppState& state);

}  // namespace stridegraph
