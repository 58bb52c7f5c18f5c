#pragma once

#include "state/app_state.h"
#include "state/commands.h"
#include "ui/lettering.h"

namespace stridegraph {

/// Where panels may be, in points.
struct Layout {
  Viewport viewport;
  /// Too narrow for panels on both sides: only tools and the timeline are shown, the rest on demand.
  bool narrow() const { return viewport.width < 760.0; }
};

/// Tools, undo and redo.
void showToolbar(const AppState& state, const Layout& layout, Lettering& lettering, Commands& commands);
/// Room, selection, body, planner.
void showScenePanel(const AppState& state, const Layout& layout, Lettering& lettering, Commands& commands);
/// What became of the plan, and what to show.
void showReportPanel(const AppState& state, const Layout& layout, Lettering& lettering, Commands& commands);
/// Orbit, follow, top.
void showCameraBar(const AppState& state, const Layout& layout, Commands& commands);
/// Playback with every frame of the walk: captured or blended, and which foot is down.
void showTimeline(const AppState& state, const Layout& layout, Commands& commands);
/// Handles of the selection, the size of what is drawn, and notices, over the view.
void showOverlay(const AppState& state, const CameraView& view, const Layout& layout, Lettering& lettering);

}  // namespace stridegraph
