#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "scene/scene_limits.h"
#include "state/editor.h"
#include "state/text_runs.h"
#include "ui/panels.h"
#include "ui/selection_fields.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace stridegraph {

namespace {

constexpr float kPanelWidth = 236.0F;
constexpr std::size_t kMostNameCodePoints = 120;

void roomFields(const AppState& state, const Palette& palette, Commands& commands) {
  heading("Room", palette);
  Scene scene = state.scene;
  const NumberField width{"Width", 0.1, kSmallestRoomMetres, kLargestRoomMetres, "%.1f m"};
  const NumberField depth{"Depth", 0.1, kSmallestRoomMetres, kLargestRoomMetres, "%.1f m"};
  if (numberField(width, scene.widthMetres)) edit(scene, "Change room width", commands);
  scene = state.scene;
  if (numberField(depth, scene.depthMetres)) edit(scene, "Change room depth", commands);
}

/// A limit that may be set: a box to tick, and its fields once it is.
void speedFields(const AppState& state, Commands& commands) {
  constexpr double kUsualLeast = 0.5, kUsualMost = 1.6;
  Scene scene = state.scene;
  WalkConstraints& constraints = scene.constraints;
  bool limited = constraints.minSpeedMetresPerSecond || constraints.maxSpeedMetresPerSecond;
  if (ImGui::Checkbox("Keep within a speed", &limited)) {
    constraints.minSpeedMetresPerSecond = limited ? std::optional(kUsualLeast) : std::nullopt;
    constraints.maxSpeedMetresPerSecond = limited ? std::optional(kUsualMost) : std::nullopt;
    commands.push_back(EditScene{"Limit speed", scene});
  }
  if (!limited) return;
  double least = constraints.minSpeedMetresPerSecond.value_or(0.0);
  double most = constraints.maxSpeedMetresPerSecond.value_or(kMostMetresPerSecond);
  if (numberField({"At least", 0.05, 0.0, most, "%.2f m/s"}, least)) {
    constraints.minSpeedMetresPerSecond = least;
    edit(scene, "Change least speed", commands);
  }
  scene = state.scene;
  if (numberField({"At most", 0.05, least, kMostMetresPerSecond, "%.2f m/s"}, most)) {
    constraints.maxSpeedMetresPerSecond = most;
    edit(scene, "Change greatest speed", commands);
  }
}

void arrivalFields(const AppState& state, Commands& commands) {
  constexpr double kUsualSeconds = 20.0, kLeastSeconds = 1.0;
  Scene scene = state.scene;
  std::optional<double>& latest = scene.constraints.latestArrivalSeconds;
  bool limited = latest.has_value();
  if (ImGui::Checkbox("Arrive in time", &limited)) {
    latest = limited ? std::optional(kUsualSeconds) : std::nullopt;
    commands.push_back(EditScene{"Limit arrival", scene});
  }
  if (!limited || !latest) return;
  if (numberField({"At latest", 0.1, kLeastSeconds, kMostArrivalSeconds, "%.1f s"}, *latest)) {
    edit(scene, "Change latest arrival", commands);
  }
}

/// Who walks, and what every walk keeps to.
void walkFields(const AppState& state, const Palette& palette, Commands& commands) {
  if (!section("Walk", true, palette)) return;
  Scene scene = state.scene;
  if (numberField({"Body radius", 0.01, 0.05, 5.0, "%.2f m"}, scene.radiusMetres)) {
    edit(scene, "Change body radius", commands);
  }
  scene = state.scene;
  std::optional<Gait>& gait = scene.constraints.gait;
  static constexpr std::array<const char*, 3> kGaits = {"Any", "Walk only", "Run only"};
  int chosen = gait ? 1 + static_cast<int>(*gait) : 0;
  if (choiceField("Gait", chosen, kGaits)) {
    gait = chosen == 0 ? std::nullopt : std::optional(static_cast<Gait>(chosen - 1));
    commands.push_back(EditScene{"Change gait", scene});
  }
  speedFields(state, commands);
  arrivalFields(state, commands);
}

void plannerFields(const AppState& state, const Palette& palette, Commands& commands) {
  if (!section("Planning", false, palette)) return;
  PlanSettings settings = state.settings;
  if (numberField({"Goal radius", 0.01, 0.01, 5.0, "%.2f m"}, settings.goalRadiusMetres)) {
    commands.push_back(ChangeSettings{settings});
  }
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Seed");
  ImGui::SameLine(92.0F);
  const float button = ImGui::CalcTextSize("Next").x + 18.0F;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button - 6.0F);
  Scene scene = state.scene;
  if (ImGui::InputScalar("##seed", ImGuiDataType_U64, &scene.seed)) edit(scene, "Change seed", commands);
  ImGui::SameLine(0.0F, 6.0F);
  if (ImGui::Button("Next", ImVec2(button, 0.0F))) {
    scene.seed = state.scene.seed + 1;
    commands.push_back(EditScene{"Change seed", scene});
  }
  static constexpr std::array<const char*, 2> kPlanners = {"Roadmap (PRM)", "RRT-Connect"};
  static constexpr std::array<const char*, 3> kSearches = {"Guided", "Thesis", "Thesis, checked"};
  const bool otherPlanner = choiceField("Planner", settings.planner, kPlanners);
  if (choiceField("Search", settings.search, kSearches) || otherPlanner)
    commands.push_back(ChangeSettings{settings});
}

}  // namespace

void showScenePanel(const AppState& state, const Layout& layout, Lettering& lettering, Commands& commands) {
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
  const std::string name = shortened(state.scene.name, kMostNameCodePoints);
  ImGui::TextUnformatted(name.empty() ? "Untitled room" : lettering.shown(name).c_str());
  ImGui::Separator();
  roomFields(state, palette, commands);
  showSelectionFields(state, commands);
  walkFields(state, palette, commands);
  plannerFields(state, palette, commands);
  ImGui::End();
}

}  // namespace stridegraph
