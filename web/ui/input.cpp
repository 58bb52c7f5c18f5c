#include "ui/input.h"

#include <imgui.h>

#include <algorithm>

namespace stridegraph {

namespace {

constexpr std::array<std::pair<ImGuiKey, Key>, 18> kKnownToImGui = {{
    {ImGuiKey_Tab, Key::kTab},
    {ImGuiKey_LeftArrow, Key::kLeft},
    {ImGuiKey_RightArrow, Key::kRight},
    {ImGuiKey_UpArrow, Key::kUp},
    {ImGuiKey_DownArrow, Key::kDown},
    {ImGuiKey_Home, Key::kHome},
    {ImGuiKey_End, Key::kEnd},
    {ImGuiKey_Insert, Key::kInsert},
    {ImGuiKey_Delete, Key::kDelete},
    {ImGuiKey_Backspace, Key::kBackspace},
    {ImGuiKey_Enter, Key::kEnter},
    {ImGuiKey_Escape, Key::kEscape},
    {ImGuiKey_A, Key::kA},
    {ImGuiKey_C, Key::kC},
    {ImGuiKey_V, Key::kV},
    {ImGuiKey_X, Key::kX},
    {ImGuiKey_Y, Key::kY},
    {ImGuiKey_Z, Key::kZ},
}};

void setModifiers(InputState& state, const Modifiers& modifiers) {
  state.modifiers = modifiers;
  ImGuiIO& io = ImGui::GetIO();
  io.KeyCtrl = modifiers.control;
  io.KeyShift = modifiers.shift;
  io.KeyAlt = modifiers.alt;
}

void see(const InputEvent& event, InputState& state) {
  ImGuiIO& io = ImGui::GetIO();
  setModifiers(state, event.modifiers);
  const auto button = static_cast<std::size_t>(event.button);
  switch (event.kind) {
    case InputKind::kPress:
    case InputKind::kRelease:
      state.touch = event.touch;
      state.down[button] = event.kind == InputKind::kPress;
      [[fallthrough]];
    case InputKind::kMove:
      state.pointer = event.position;
      break;
    case InputKind::kLeave:
      state.pointer = Vec2::Constant(-1e6);
      break;
    case InputKind::kWheel:
      io.MouseWheel -= static_cast<float>(event.wheel);
      break;
    case InputKind::kKeyDown:
    case InputKind::kKeyUp:
      io.KeysDown[static_cast<int>(event.key)] = event.kind == InputKind::kKeyDown;
      break;
    case InputKind::kText:
      io.AddInputCharacter(event.character);
      break;
    case InputKind::kPinch:
      break;
  }
}

bool changesSameKey(const std::deque<InputEvent>& taken, const InputEvent& next) {
  const auto isKey = [](const InputEvent& event) {
    return event.kind == InputKind::kKeyDown || event.kind == InputKind::kKeyUp;
  };
  if (!isKey(next)) return false;
  const auto changes = [&](const InputEvent& event) { return isKey(event) && event.key == next.key; };
  return std::any_of(taken.begin(), taken.end(), changes);
}

}  // namespace

std::deque<InputEvent> InputQueue::take(InputState& state) {
  std::deque<InputEvent> taken;
  bool pressed = false;
  while (!events_.empty()) {
    const InputEvent& next = events_.front();
    const bool presses = next.kind == InputKind::kPress || next.kind == InputKind::kRelease;
    // A frame sees at most one press or release and no move that comes after it. A text field, which looks at
    // keys once a frame, must not miss one that goes down and up; shortcuts are told by events.
    if (pressed && (presses || next.kind == InputKind::kMove)) break;
    if (ImGui::GetIO().WantTextInput && changesSameKey(taken, next)) break;
    pressed = pressed || presses;
    see(next, state);
    taken.push_back(next);
    events_.pop_front();
  }
  ImGuiIO& io = ImGui::GetIO();
  io.MousePos = ImVec2(static_cast<float>(state.pointer.x()), static_cast<float>(state.pointer.y()));
  for (std::size_t i = 0; i < state.down.size(); ++i) io.MouseDown[i] = state.down[i];
  return taken;
}

void mapKeysForImGui() {
  ImGuiIO& io = ImGui::GetIO();
  for (const auto& [theirs, ours] : kKnownToImGui) io.KeyMap[theirs] = static_cast<int>(ours);
}

}  // namespace stridegraph
