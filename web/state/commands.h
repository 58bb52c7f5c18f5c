#pragma once

#include <string>
#include <variant>
#include <vector>

#include "state/app_state.h"

namespace stridegraph {

/// Puts another scene in the place of the present one, as one step that can be undone.
struct EditScene {
  std::string label;
  Scene scene;
  /// Steps with the same non-empty key in a row are one step: a field that is dragged, a key held down.
  std::string mergeKey = {};
};

/// Opens a scene that has nothing to do with the present one: selection, playback and view start afresh.
struct OpenScene {
  std::string label;
  Scene scene;
};

struct Undo {};
struct Redo {};
struct Select {
  Item item;
};
struct ChooseTool {
  Tool tool;
};
struct DeleteSelection {};
struct ChangeSettings {
  PlanSettings settings;
};
struct ChangePlayback {
  Playback playback;
};
struct StepFrames {
  int frames;
};
struct ChangeView {
  ViewOptions view;
};
struct ChooseCamera {
  CameraMode mode;
  Viewport viewport;
};
struct ShowWholeRoom {
  Viewport viewport;
};
struct Say {
  std::string text;
  bool problem = false;
};

using Command =
    std::variant<EditScene, OpenScene, Undo, Redo, Select, ChooseTool, DeleteSelection, ChangeSettings,
                 ChangePlayback, StepFrames, ChangeView, ChooseCamera, ShowWholeRoom, Say>;
using Commands = std::vector<Command>;

/// The one place where commands change the state.
void apply(AppState& state, const Command& command);
void applyAll(AppState& state, const Commands& commands);

}  // namespace stridegraph
