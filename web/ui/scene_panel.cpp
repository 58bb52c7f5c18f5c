#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <string>

#include "state/editor.h"
#include "ui/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace stridegraph {

namespace {

constexpr float kPanelWidth = 236.0F;

/// A change by a field: all that happen without letting go of it are one step to undo.
void edit(const Scene& scene, const char* label, Commands& commands) {
  const std::string key = fmt::format("{} {}", label, ImGui::GetIO().MouseClickedTime[0]);
  commands.push_back(EditScene{label, scene, key});
}

void roomFields(const AppState& state, const Palette& palette, Commands& commands) {
  heading("Room", palette);
  Scene scene = state.scene;
  const NumberField width{"Width", 0.1, kSmallestRoomMetres, kLargestRoomMetres, "%.1f m"};
  const NumberField depth{"Depth", 0.1, kSmallestRoomMetres, kLargestRoomMetres, "%.1f m"};
  if (numberField(width, scene.widthMetres)) edit(scene, "Change room width", commands);
  scene = state.scene;
  if (numberField(depth, scene.depthMetres)) edit(scene, "Change room depth", commands);
}

void blockFields(const AppState& state, Commands& commands) {
  const std::size_t index = state.selection.obstacle;
  const Scene& scene = state.scene;
  struct BlockField {
    NumberField field;
    int axis;
    bool size;
  };
  const std::array<BlockField, 4> fields = {{
      {{"x", 0.1, 0.0, scene.widthMetres, "%.2f m"}, 0, false},
      {{"z", 0.1, 0.0, scene.depthMetres, "%.2f m"}, 1, false},
      {{"Width", 0.1, kSmallestBlockMetres, kLargestRoomMetres, "%.2f m"}, 0, true},
      {{"Depth", 0.1, kSmallestBlockMetres, kLargestRoomMetres, "%.2f m"}, 1, true},
  }};
  for (const BlockField& each : fields) {
    Rectangle block = scene.obstacles[index];
    double& value = each.size ? block.size[each.axis] : block.centre[each.axis];
    if (!numberField(each.field, value)) continue;
    Scene changed = scene;
    changed.obstacles[index] = block;
    edit(changed, "Change block", commands);
  }
  if (ImGui::Button("Delete block", ImVec2(-1.0F, 0.0F))) commands.push_back(DeleteSelection{});
}

void placementFields(const AppState& state, Commands& commands) {
  const bool start = state.selection.kind == ItemKind::kStart;
  const auto of = [start](Scene& scene) -> Placement& { return start ? scene.start : scene.goal; };
  const char* label = start ? "Change start" : "Change goal";
  const std::array<NumberField, 2> fields = {{{"x", 0.05, 0.0, state.scene.widthMetres, "%.2f m"},
                                              {"z", 0.05, 0.0, state.scene.depthMetres, "%.2f m"}}};
  for (int axis = 0; axis < 2; ++axis) {
    Scene scene = state.scene;
    if (numberField(fields[static_cast<std::size_t>(axis)], of(scene).position[axis])) {
      edit(scene, label, commands);
    }
  }
  Scene scene = state.scene;
  Placement& placement = of(scene);
  bool faces = placement.heading.has_value();
  if (ImGui::Checkbox("Face a direction", &faces)) {
    placement.heading = faces ? std::optional(Angle()) : std::nullopt;
    commands.push_back(EditScene{label, scene});
  }
  if (!placement.heading) return;
  double degrees = headingDegrees(placement);
  if (numberField({"Heading", 1.0, -180.0, 180.0, "%.0f\xc2\xb0"}, degrees)) {
    placement.heading = Angle::degrees(degrees);
    edit(scene, "Turn heading", commands);
  }
}

void selectionFields(const AppState& state, const Palette& palette, Commands& commands) {
  const bool block =
      state.selection.kind == ItemKind::kObstacle && state.selection.obstacle < state.scene.obstacles.size();
  if (!block && state.selection.kind != ItemKind::kStart && state.selection.kind != ItemKind::kGoal) {
    heading("Nothing is chosen", palette);
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextColored(asImVec4(palette.quietText),
                       "Draw blocks with B, drag start and goal where you like.");
    ImGui::PopTextWrapPos();
    return;
  }
  if (block) {
    heading(fmt::format("Block {} of {}", state.selection.obstacle + 1, state.scene.obstacles.size()).c_str(),
            palette);
    blockFields(state, commands);
    return;
  }
  heading(state.selection.kind == ItemKind::kStart ? "Start" : "Goal", palette);
  placementFields(state, commands);
}

void plannerFields(const AppState& state, const Palette& palette, Commands& commands) {
  heading("Walk", palette);
  Scene scene = state.scene;
  if (numberField({"Body radius", 0.01, 0.05, 5.0, "%.2f m"}, scene.radiusMetres)) {
    edit(scene, "Change body radius", commands);
  }
  PlanSettings settings = state.settings;
  if (numberField({"Goal radius", 0.01, 0.01, 5.0, "%.2f m"}, settings.goalRadiusMetres)) {
    commands.push_back(ChangeSettings{settings});
  }
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Seed");
  ImGui::SameLine(92.0F);
  const float button = ImGui::CalcTextSize("Next").x + 18.0F;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button - 6.0F);
  scene = state.scene;
  if (ImGui::InputScalar("##seed", ImGuiDataType_U64, &scene.seed)) edit(scene, "Change seed", commands);
  ImGui::SameLine(0.0F, 6.0F);
  if (ImGui::Button("Next", ImVec2(button, 0.0F))) {
    scene.seed = state.scene.seed + 1;
    commands.push_back(EditScene{"Change seed", scene});
  }
  const auto choice = [&](const char* label, int current, std::initializer_list<const char*> names) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    ImGui::SameLine(92.0F);
    ImGui::SetNextItemWidth(-1.0F);
    ImGui::PushID(label);
    ImGui::Combo("##choice", &current, names.begin(), static_cast<int>(names.size()));
    ImGui::PopID();
    return current;
  };
  const int planner = choice("Planner", static_cast<int>(settings.planner), {"Roadmap (PRM)", "RRT-Connect"});
  const int search =
      choice("Search", static_cast<int>(settings.search), {"Guided", "Thesis", "Thesis, checked"});
  settings.planner = static_cast<PlannerKind>(planner);
  settings.search = static_cast<SearchKind>(search);
  if (settings.planner != state.settings.planner || settings.search != state.settings.search) {
    commands.push_back(ChangeSettings{settings});
  }
}

}  // namespace

void showScenePanel(const AppState& state, const Layout& layout, Commands& commands) {
  if (layout.narrow()) return;
  const Palette& palette = paletteFor(state.view.dark);
  constexpr float kTop = 68.0F, kBottom = 118.0F;
  const float room = std::max(120.0F, static_cast<float>(layout.viewport.height) - kTop - kBottom);
  ImGui::SetNextWindowPos(ImVec2(14.0F, kTop));
  ImGui::SetNextWindowSizeConstraints(ImVec2(kPanelWidth, 0.0F), ImVec2(kPanelWidth, room));
  ImGui::Begin("Scene", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::TextUnformatted(state.scene.name.empty() ? "Untitled room" : state.scene.name.c_str());
  ImGui::Separator();
  roomFields(state, palette, commands);
  selectionFields(state, palette, commands);
  plannerFields(state, palette, commands);
  ImGui::End();
}

}  // namespace stridegraph
