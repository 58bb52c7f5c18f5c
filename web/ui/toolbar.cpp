#include <array>
#include <string>

#include "state/items.h"
#include "ui/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace stridegraph {

namespace {

constexpr ImGuiWindowFlags kBarFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                                       ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;
constexpr float kMargin = 14.0F;

void beginBar(const char* name, ImVec2 at, ImVec2 pivot) {
  ImGui::SetNextWindowPos(at, ImGuiCond_Always, pivot);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(5.0F, 5.0F));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(3.0F, 3.0F));
  ImGui::Begin(name, nullptr, kBarFlags);
}

void endBar() {
  ImGui::End();
  ImGui::PopStyleVar(2);
}

}  // namespace

void showToolbar(const AppState& state, const Layout& layout, Lettering& lettering, Commands& commands) {
  const Palette& palette = paletteFor(state.view.dark);
  struct ToolButton {
    Tool tool;
    IconButton button;
  };
  const std::array<ToolButton, 7> tools = {{
      {Tool::kSelect, {Icon::kSelect, "select", "Select, move and resize (V)"}},
      {Tool::kBlock, {Icon::kBlock, "block", "Draw a block (B)"}},
      {Tool::kMoving,
       {Icon::kMoving, "moving", "Draw a moving block: drag from where it is to where it goes (M)"}},
      {Tool::kArea, {Icon::kArea, "area", "Draw an area to avoid or to prefer (A)"}},
      {Tool::kStart, {Icon::kStart, "start", "Place the start; drag to turn it (S)"}},
      {Tool::kGoal, {Icon::kGoal, "goal", "Place the goal; drag to turn it (G)"}},
      {Tool::kWalker, {Icon::kWalker, "walker", "Add a walker: drag from its start to its goal (W)"}},
  }};
  beginBar("Tools", ImVec2(kMargin, kMargin), ImVec2(0.0F, 0.0F));
  for (const ToolButton& each : tools) {
    IconButton button = each.button;
    button.chosen = state.tool == each.tool;
    if (iconButton(button, palette)) commands.push_back(ChooseTool{each.tool});
    ImGui::SameLine();
  }
  if (layout.narrow()) {
    ImGui::NewLine();
  } else {
    ImGui::Dummy(ImVec2(4.0F, 1.0F));
    ImGui::SameLine();
  }
  const auto& past = state.history.past;
  const auto& future = state.history.future;
  const std::string undo = past.empty() ? "Nothing to undo" : "Undo: " + past.back().label + " (Ctrl+Z)";
  const std::string redo =
      future.empty() ? "Nothing to redo" : "Redo: " + future.back().label + " (Ctrl+Shift+Z)";
  if (iconButton({Icon::kUndo, "undo", lettering.shown(undo).c_str(), false, !past.empty()}, palette))
    commands.push_back(Undo{});
  ImGui::SameLine();
  if (iconButton({Icon::kRedo, "redo", lettering.shown(redo).c_str(), false, !future.empty()}, palette))
    commands.push_back(Redo{});
  ImGui::SameLine();
  const bool canDelete = isRemovable(state.scene, state.selection);
  const std::string remove =
      canDelete ? "Delete the chosen " + kindName(state.selection) + " (Del)" : "Nothing to delete is chosen";
  if (iconButton({Icon::kDelete, "delete", remove.c_str(), false, canDelete}, palette)) {
    commands.push_back(DeleteSelection{});
  }
  endBar();
}

void showCameraBar(const AppState& state, const Layout& layout, Commands& commands) {
  const Palette& palette = paletteFor(state.view.dark);
  const bool narrow = layout.narrow();
  const auto width = static_cast<float>(layout.viewport.width);
  const ImVec2 at = narrow ? ImVec2(width - kMargin, kMargin + 52.0F) : ImVec2(width / 2.0F + 20.0F, kMargin);
  beginBar("Camera", at, narrow ? ImVec2(1.0F, 0.0F) : ImVec2(0.5F, 0.0F));
  struct ModeButton {
    CameraMode mode;
    IconButton button;
  };
  const std::array<ModeButton, 3> modes = {{
      {CameraMode::kOrbit,
       {Icon::kOrbit, "orbit", "Look around: drag to turn, right-drag to move, wheel to zoom (1)"}},
      {CameraMode::kFollow, {Icon::kFollow, "follow", "Walk along with the body (2)"}},
      {CameraMode::kTop, {Icon::kTop, "top", "Plan view from above (3)"}},
  }};
  const std::array<const char*, 3> labels = {"Orbit", "Follow", "Top"};
  for (std::size_t i = 0; i < modes.size(); ++i) {
    IconButton button = modes[i].button;
    button.chosen = state.camera.mode == modes[i].mode;
    if (!narrow) button.label = labels[i];
    if (iconButton(button, palette)) commands.push_back(ChooseCamera{modes[i].mode, layout.viewport});
    if (!narrow) ImGui::SameLine();
  }
  if (iconButton({Icon::kWhole, "whole", "Show the whole room (F)"}, palette)) {
    commands.push_back(ShowWholeRoom{layout.viewport});
  }
  endBar();
}

}  // namespace stridegraph
