#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "state/walk_marks.h"
#include "ui/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"
#include "walk/keeping.h"

namespace stridegraph {

namespace {

constexpr float kPanelWidth = 240.0F;

void showStatus(const AppState& state, const Palette& palette, Lettering& lettering) {
  const bool arrived = state.plan && !state.troubleOnWay && allArrive(*state.plan);
  const Colour& colour = !state.plan && state.planError.empty() ? palette.quietText
                         : arrived                              ? palette.good
                                                                : palette.problem;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float middle = corner.y + ImGui::GetFontSize() * 0.5F + 1.0F;
  ImGui::GetWindowDrawList()->AddCircleFilled(ImVec2(corner.x + 5.0F, middle), 4.5F, asImU32(colour), 16);
  ImGui::Indent(16.0F);
  ImGui::PushTextWrapPos(0.0F);
  ImGui::TextUnformatted(lettering.shown(statusSentence(state)).c_str());
  ImGui::PopTextWrapPos();
  ImGui::Unindent(16.0F);
}

void showFigures(const PlanReport& report, const Palette& palette) {
  figure("Path", fmt::format("{:.2f} m", report.pathLengthMetres), palette);
  if (report.status == PlanStatus::kArrived) {
    figure("Walk", fmt::format("{:.2f} m", report.motionLengthMetres), palette);
    figure("Duration", fmt::format("{:.1f} s, {} frames", report.durationSeconds, report.frames), palette);
    figure("Clearance", fmt::format("{:.2f} m", report.clearanceMetres), palette);
    if (report.movingClearanceMetres)
      figure("From what moves", fmt::format("{:.2f} m", *report.movingClearanceMetres), palette);
    if (report.goalFreeUntilSeconds)
      figure("Goal free until", fmt::format("{:.1f} s", *report.goalFreeUntilSeconds), palette);
    figure("Transitions", fmt::format("{} of {} edges", report.transitions, report.edges.size()), palette);
  }
  figure("Expansions", fmt::format("{}", report.expansions), palette);
  ImGui::Separator();
  figure("Path planning", fmt::format("{:.1f} ms", report.pathMilliseconds), palette);
  figure("Motion search", fmt::format("{:.1f} ms", report.motionMilliseconds), palette);
  figure("Synthesis", fmt::format("{:.1f} ms", report.synthesisMilliseconds), palette);
}

/// How clean the walk is; a click on the worst of something shows its frame.
void showQuality(const AppState& state, const Palette& palette, Commands& commands) {
  const PlanReport& report = state.plan->report;
  if (report.status != PlanStatus::kArrived) return;
  ImGui::Separator();
  figure("Foot skate",
         fmt::format("{:.1f} cm/s (clips {:.1f})", report.footSkateCmPerSecond,
                     report.footSkateSourceCmPerSecond),
         palette);
  figure("Feet pinned",
         fmt::format("{} times, {:.1f} cm", report.contacts, 100.0 * report.feetCorrectedMeanMetres),
         palette);
  figure("From the goal",
         report.arrivalHeadingError
             ? fmt::format("{:.1f} cm, {:.1f}\xc2\xb0", 100.0 * report.arrivalErrorMetres,
                           report.arrivalHeadingError->degrees())
             : fmt::format("{:.1f} cm", 100.0 * report.arrivalErrorMetres),
         palette);
  for (const WalkMark& mark : walkMarks(report)) {
    if (!figureLink(mark.name.c_str(), mark.value, mark.where.c_str(), palette)) continue;
    Playback playback = state.playback;
    playback.seconds = static_cast<double>(mark.frame) / state.plan->walk.framesPerSecond;
    playback.playing = false;
    commands.push_back(ChangePlayback{playback});
  }
}

void showViewOptions(const AppState& state, Commands& commands) {
  ImGui::Separator();
  ViewOptions view = state.view;
  const std::array<std::pair<const char*, bool*>, 6> options = {{{"Roadmap", &view.roadmap},
                                                                 {"Path", &view.path},
                                                                 {"Subgoals", &view.subgoals},
                                                                 {"Trail", &view.trail},
                                                                 {"Footprints", &view.footprints},
                                                                 {"Tint blends", &view.tintBlends}}};
  bool changed = false;
  for (std::size_t i = 0; i < options.size(); ++i) {
    if (i % 2 == 1) ImGui::SameLine(kPanelWidth / 2.0F);
    changed = ImGui::Checkbox(options[i].first, options[i].second) || changed;
  }
  if (changed) commands.push_back(ChangeView{view});
}

}  // namespace

void showReportPanel(const AppState& state, const Layout& layout, Lettering& lettering, Commands& commands) {
  const Palette& palette = paletteFor(state.view.dark);
  const auto width = static_cast<float>(layout.viewport.width);
  constexpr float kBottom = 118.0F;
  ImVec2 at(width - 14.0F, 14.0F), pivot(1.0F, 0.0F);
  if (layout.narrow()) {
    at = ImVec2(width / 2.0F, static_cast<float>(layout.viewport.height) - kBottom);
    pivot = ImVec2(0.5F, 1.0F);
  }
  const float room = std::max(80.0F, static_cast<float>(layout.viewport.height) - 14.0F - kBottom);
  ImGui::SetNextWindowPos(at, ImGuiCond_Always, pivot);
  ImGui::SetNextWindowSizeConstraints(ImVec2(kPanelWidth, 0.0F), ImVec2(kPanelWidth, room));
  ImGui::Begin("Report", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  showStatus(state, palette, lettering);
  if (!layout.narrow()) {
    if (state.plan) {
      ImGui::Separator();
      if (!state.plan->others.empty()) heading("Walker 1", palette);
      showFigures(state.plan->report, palette);
      showQuality(state, palette, commands);
    }
    showViewOptions(state, commands);
  }
  ImGui::End();
}

}  // namespace stridegraph
