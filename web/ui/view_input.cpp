#include "ui/view_input.h"

#include <cmath>

#include "state/editor.h"
#include "state/planning.h"
#include "state/playback.h"

namespace stridegraph {

namespace {

constexpr double kClickPoints = 4.0;

PointerAt pointerOf(const InputEvent& event) {
  return {event.position, event.modifiers.alt, event.touch ? 22.0 : 9.0};
}

void press(AppState& state, ViewInput& input, const CameraView& view, const InputEvent& event) {
  input.pressedAt = input.last = event.position;
  input.button = event.button;
  if (event.button == 0 && !event.modifiers.shift) {
    state.drag = beginDrag(state, view, pointerOf(event));
    if (state.drag) {
      input.gesture = ViewGesture::kEdit;
      if (state.drag->selectAfter && !state.drag->drawnWith) state.selection = *state.drag->selectAfter;
      return;
    }
  }
  const bool turns = event.button == 0 && !event.modifiers.shift && state.camera.mode != CameraMode::kTop;
  input.gesture = turns ? ViewGesture::kTurn : ViewGesture::kPan;
}

void move(AppState& state, ViewInput& input, const CameraView& view, const InputEvent& event) {
  const Vec2 by = event.position - input.last;
  input.last = event.position;
  switch (input.gesture) {
    case ViewGesture::kNone:
      break;
    case ViewGesture::kTurn:
      turn(state.camera, by);
      break;
    case ViewGesture::kPan:
      pan(state.camera, by, view.viewport);
      break;
    case ViewGesture::kEdit:
      // A click that trembles is still a click.
      if (state.drag && (state.drag->moved || (event.position - input.pressedAt).norm() > kClickPoints)) {
        moveDrag(*state.drag, view, pointerOf(event));
        wantPlan(state);
      }
      break;
  }
}

void release(AppState& state, ViewInput& input, const CameraView& view, const InputEvent& event,
             Commands& commands) {
  const bool clicked = (event.position - input.pressedAt).norm() <= kClickPoints;
  if (input.gesture == ViewGesture::kEdit && state.drag) {
    const Commands made = finishDrag(*state.drag);
    commands.insert(commands.end(), made.begin(), made.end());
    state.drag.reset();
  } else if (clicked && input.gesture != ViewGesture::kNone && input.button == 0) {
    commands.push_back(Select{areaUnder(state, view, pointerOf(event))});
  }
  input.gesture = ViewGesture::kNone;
}

void wheel(AppState& state, const CameraView& view, const InputEvent& event) {
  const std::optional<Vec2> about = meetPlane(view.rayAt(event.position), 0.0);
  // Towards the horizon the floor under the pointer is far away: zoom about the middle instead.
  const Vec2 fromTarget = about ? Vec2(*about - state.camera.wanted.target) : Vec2(Vec2::Zero());
  const bool reasonable = about && fromTarget.norm() < 3.0 * state.camera.wanted.halfHeightMetres;
  zoom(state.camera, std::exp(0.14 * event.wheel), reasonable ? about : std::nullopt);
}

void pinch(AppState& state, ViewInput& input, const CameraView& view, const InputEvent& event) {
  // A second finger turns what the first began into a camera move.
  state.drag.reset();
  input.gesture = ViewGesture::kNone;
  pan(state.camera, event.drag, view.viewport);
  zoom(state.camera, 1.0 / std::max(event.scale, 0.05), std::nullopt);
  if (state.camera.mode != CameraMode::kTop) state.camera.wanted.yawRadians -= event.twistRadians;
}

void nudgeSelection(const AppState& state, Key key, Commands& commands) {
  if (state.selection.kind == ItemKind::kNothing) return;
  Vec2 by = Vec2::Zero();
  if (key == Key::kLeft) by.x() = -kSnapMetres;
  if (key == Key::kRight) by.x() = kSnapMetres;
  if (key == Key::kUp) by.y() = -kSnapMetres;
  if (key == Key::kDown) by.y() = kSnapMetres;
  commands.push_back(EditScene{"Nudge", nudged(state.scene, state.selection, by), "nudge"});
}

void shortcut(const AppState& state, const InputEvent& event, Commands& commands) {
  if (event.key == Key::kZ) commands.push_back(event.modifiers.shift ? Command(Redo{}) : Command(Undo{}));
  if (event.key == Key::kY) commands.push_back(Redo{});
  static_cast<void>(state);
}

void toolKey(const AppState& state, Key key, const Viewport& viewport, Commands& commands) {
  switch (key) {
    case Key::kV:
      commands.push_back(ChooseTool{Tool::kSelect});
      break;
    case Key::kB:
      commands.push_back(ChooseTool{Tool::kBlock});
      break;
    case Key::kM:
      commands.push_back(ChooseTool{Tool::kMoving});
      break;
    case Key::kA:
      commands.push_back(ChooseTool{Tool::kArea});
      break;
    case Key::kW:
      commands.push_back(ChooseTool{Tool::kWalker});
      break;
    case Key::kS:
      commands.push_back(ChooseTool{Tool::kStart});
      break;
    case Key::kG:
      commands.push_back(ChooseTool{Tool::kGoal});
      break;
    case Key::kF:
      commands.push_back(ShowWholeRoom{viewport});
      break;
    case Key::kDelete:
    case Key::kBackspace:
      commands.push_back(DeleteSelection{});
      break;
    case Key::kSpace:
      commands.push_back(ChangePlayback{playToggled(state)});
      break;
    case Key::kEscape:
      commands.push_back(Select{});
      commands.push_back(ChooseTool{Tool::kSelect});
      break;
    default:
      break;
  }
}

void keyDown(AppState& state, const Viewport& viewport, const InputEvent& event, Commands& commands) {
  if (event.modifiers.control) return shortcut(state, event, commands);
  const Key key = event.key;
  const bool arrow = key == Key::kLeft || key == Key::kRight || key == Key::kUp || key == Key::kDown;
  if (arrow && event.modifiers.shift) return nudgeSelection(state, key, commands);
  if (key == Key::kLeft) commands.push_back(StepFrames{-1});
  if (key == Key::kRight) commands.push_back(StepFrames{1});
  if (key == Key::kHome || key == Key::kEnd) {
    Playback playback = state.playback;
    playback.seconds = key == Key::kHome ? 0.0 : state.walkSeconds();
    commands.push_back(ChangePlayback{playback});
  }
  toolKey(state, key, viewport, commands);
}

void typed(unsigned character, const Viewport& viewport, Commands& commands) {
  if (character == '1') commands.push_back(ChooseCamera{CameraMode::kOrbit, viewport});
  if (character == '2') commands.push_back(ChooseCamera{CameraMode::kFollow, viewport});
  if (character == '3') commands.push_back(ChooseCamera{CameraMode::kTop, viewport});
}

}  // namespace

Commands handleEvents(AppState& state, ViewInput& input, const CameraView& view,
                      const std::deque<InputEvent>& events, const InputClaims& claims) {
  Commands commands;
  for (const InputEvent& event : events) {
    switch (event.kind) {
      case InputKind::kPress:
        if (!claims.pointer && input.gesture == ViewGesture::kNone) press(state, input, view, event);
        break;
      case InputKind::kMove:
        move(state, input, view, event);
        break;
      case InputKind::kRelease:
        if (event.button == input.button) release(state, input, view, event, commands);
        break;
      case InputKind::kWheel:
        if (!claims.pointer) wheel(state, view, event);
        break;
      case InputKind::kPinch:
        if (!claims.pointer) pinch(state, input, view, event);
        break;
      case InputKind::kKeyDown:
        if (!claims.keyboard) keyDown(state, view.viewport, event, commands);
        break;
      case InputKind::kText:
        if (!claims.keyboard && !event.modifiers.control) typed(event.character, view.viewport, commands);
        break;
      case InputKind::kKeyUp:
      case InputKind::kLeave:
        break;
    }
  }
  return commands;
}

Handle hoverAt(AppState& state, const ViewInput& input, const CameraView& view, const InputState& pointer,
               const InputClaims& claims) {
  if (state.drag) return state.drag->handle;
  state.hovered = {};
  const bool busy = claims.pointer || pointer.touch || input.gesture != ViewGesture::kNone;
  if (busy || pointer.pointer.x() < 0.0 || state.tool != Tool::kSelect) return {};
  const Handle handle = handleUnder(state, view, {pointer.pointer, false, 9.0});
  state.hovered = handle.item;
  return handle;
}

}  // namespace stridegraph
