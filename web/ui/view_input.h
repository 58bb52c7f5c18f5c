#pragma once

#include <deque>

#include "state/app_state.h"
#include "state/commands.h"
#include "ui/input.h"

namespace stridegraph {

/// What the pointer is doing to the view since it was pressed.
enum class ViewGesture { kNone, kEdit, kTurn, kPan };

struct ViewInput {
  ViewGesture gesture = ViewGesture::kNone;
  Vec2 pressedAt = Vec2::Zero();
  Vec2 last = Vec2::Zero();
  int button = 0;
};

/// Who else wants the input of this frame.
struct InputClaims {
  bool pointer = false;   ///< A panel is under the pointer.
  bool keyboard = false;  ///< A text is being typed.
};

/// Turns events over the view into drags, camera moves and commands.
Commands handleEvents(AppState& state, ViewInput& input, const CameraView& view,
                      const std::deque<InputEvent>& events, const InputClaims& claims);

/// Notes what the resting pointer would take hold of.
Handle hoverAt(AppState& state, const ViewInput& input, const CameraView& view, const InputState& pointer,
               const InputClaims& claims);

}  // namespace stridegraph
