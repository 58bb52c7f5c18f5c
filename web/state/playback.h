#pragma once

#include "state/app_state.h"

namespace stridegraph {

/// Lets time pass: moves the playhead, repeats or stops at the end. A walk begins when no better one is
/// looked for any more. Returns whether it moved.
bool advance(AppState& state, double deltaSeconds);

/// Playback after the play button: pauses, goes on, or starts again from the end.
Playback playToggled(const AppState& state);

/// A walker's pose on screen, 0 for the first: its walk between two frames, at whose end it stays; without a
/// walk the library's first pose, standing at the start. Empty without a library or such a walker.
std::optional<Pose> shownPose(const AppState& state, std::size_t walker = 0);

}  // namespace stridegraph
