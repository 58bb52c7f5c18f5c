#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/marks.h"
#include "state/playback.h"
#include "state/walk_marks.h"
#include "ui/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace stridegraph {

namespace {

constexpr float kTrackHeight = 34.0F;
constexpr float kKindHeight = 16.0F;
constexpr float kMarkHeight = 6.0F;
constexpr std::size_t kMarkReach = 3;  ///< Frames beside a mark that speak of it.

/// Calls `draw(first, last)` for every run of frames for which `holds`.
template <typename Holds, typename Draw>
void forRuns(std::size_t frames, const Holds& holds, const Draw& draw) {
  std::size_t first = 0;
  bool inside = false;
  for (std::size_t frame = 0; frame <= frames; ++frame) {
    const bool now = frame < frames && holds(frame);
    if (now && !inside) first = frame;
    if (!now && inside) draw(first, frame);
    inside = now;
  }
}

struct Track {
  ImVec2 corner;
  float width;
  std::size_t frames;

  float x(double frame) const {
    return corner.x + width * static_cast<float>(frame / std::max<double>(1.0, static_cast<double>(frames)));
  }
};

void drawTrack(const AppState& state, const Palette& palette, const Track& track) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto bar = [&](std::size_t first, std::size_t last, float y0, float y1, const Colour& colour) {
    list.AddRectFilled(ImVec2(track.x(static_cast<double>(first)), track.corner.y + y0),
                       ImVec2(track.x(static_cast<double>(last)), track.corner.y + y1), asImU32(colour),
                       2.0F);
  };
  const ImVec2 far(track.corner.x + track.width, track.corner.y + kKindHeight);
  list.AddRectFilled(track.corner, far, asImU32(palette.control), 4.0F);
  if (!state.hasWalk()) return;
  const Plan& plan = *state.plan;
  const std::size_t kinds = std::min(track.frames, plan.frameKinds.size());
  forRuns(
      kinds, [&](std::size_t i) { return plan.frameKinds[i] == EdgeKind::kClipPiece; },
      [&](std::size_t a, std::size_t b) { bar(a, b, 0.0F, kKindHeight, palette.body.faded(0.85F)); });
  forRuns(
      kinds, [&](std::size_t i) { return plan.frameKinds[i] == EdgeKind::kTransition; },
      [&](std::size_t a, std::size_t b) { bar(a, b, 0.0F, kKindHeight, palette.blendedBody.faded(0.9F)); });
  const std::size_t contacts = std::min(track.frames, plan.contacts.size());
  float y = kKindHeight + 3.0F;
  for (const std::vector<std::size_t>& foot : feetOf(*state.library)) {
    unsigned bits = 0;
    for (const std::size_t joint : foot) bits |= 1u << joint;
    const Colour& colour = y < kKindHeight + 6.0F ? palette.leftFoot : palette.rightFoot;
    forRuns(
        contacts, [&](std::size_t i) { return (plan.contacts[i] & bits) != 0; },
        [&](std::size_t a, std::size_t b) { bar(a, b, y, y + 5.0F, colour); });
    y += 8.0F;
    if (y > kTrackHeight) break;
  }
  for (const WalkMark& mark : walkMarks(plan.report)) {
    const float at = track.x(static_cast<double>(mark.frame));
    const float top = track.corner.y - kMarkHeight;
    list.AddTriangleFilled(ImVec2(at - 4.0F, top), ImVec2(at + 4.0F, top), ImVec2(at, track.corner.y),
                           asImU32(mark.problem ? palette.problem : palette.accent));
  }
  const double shown = state.shownSeconds() * plan.walk.framesPerSecond;
  const float x = track.x(shown);
  list.AddLine(ImVec2(x, track.corner.y - 3.0F), ImVec2(x, track.corner.y + kTrackHeight),
               asImU32(palette.text), 2.0F);
  list.AddCircleFilled(ImVec2(x, track.corner.y - 3.0F), 5.0F, asImU32(palette.text), 16);
}

void scrub(const AppState& state, const Track& track, Commands& commands) {
  ImGui::SetCursorScreenPos(ImVec2(track.corner.x, track.corner.y - 6.0F));
  ImGui::InvisibleButton("scrub", ImVec2(track.width, kTrackHeight + 8.0F));
  const bool hovered = ImGui::IsItemHovered();
  if (!state.hasWalk()) return;
  const double share = std::clamp((ImGui::GetIO().MousePos.x - track.corner.x) / track.width, 0.0F, 1.0F);
  if (ImGui::IsItemActive()) {
    Playback playback = state.playback;
    playback.seconds = share * state.walkSeconds();
    playback.playing = false;
    commands.push_back(ChangePlayback{playback});
  } else if (hovered) {
    const auto frame = static_cast<std::size_t>(share * static_cast<double>(track.frames - 1));
    const bool blend =
        frame < state.plan->frameKinds.size() && state.plan->frameKinds[frame] == EdgeKind::kTransition;
    std::string text = fmt::format("{:.2f} s, frame {}: {}", share * state.walkSeconds(), frame,
                                   blend ? "blended" : "captured");
    for (const WalkMark& mark : walkMarks(state.plan->report)) {
      const std::size_t apart = frame > mark.frame ? frame - mark.frame : mark.frame - frame;
      if (apart <= kMarkReach) text += fmt::format("\n{}", mark.where);
    }
    ImGui::SetTooltip("%s", text.c_str());
  }
}

void showButtons(const AppState& state, const Palette& palette, Commands& commands) {
  const bool can = state.canPlay();
  Playback playback = state.playback;
  if (iconButton({Icon::kToStart, "to start", "To the start (Home)", false, can}, palette)) {
    playback.seconds = 0.0;
    commands.push_back(ChangePlayback{playback});
  }
  ImGui::SameLine();
  if (iconButton({Icon::kStepBack, "back", "One frame back (Left)", false, can}, palette)) {
    commands.push_back(StepFrames{-1});
  }
  ImGui::SameLine();
  const Icon icon = playback.playing ? Icon::kPause : Icon::kPlay;
  if (iconButton({icon, "play", "Play or pause (Space)", can, can}, palette)) {
    commands.push_back(ChangePlayback{playToggled(state)});
  }
  ImGui::SameLine();
  if (iconButton({Icon::kStepOn, "on", "One frame on (Right)", false, can}, palette))
    commands.push_back(StepFrames{1});
  ImGui::SameLine();
  if (iconButton({Icon::kLoop, "loop", playback.loop ? "Repeats" : "Stops at the end", playback.loop, true},
                 palette)) {
    playback.loop = !playback.loop;
    commands.push_back(ChangePlayback{playback});
  }
}

void showSpeed(const AppState& state, Commands& commands) {
  Playback playback = state.playback;
  auto speed = static_cast<float>(playback.speed);
  ImGui::SetNextItemWidth(84.0F);
  if (ImGui::SliderFloat("##speed", &speed, 0.1F, 2.0F, "", ImGuiSliderFlags_AlwaysClamp)) {
    playback.speed = std::round(speed * 20.0F) / 20.0F;
    commands.push_back(ChangePlayback{playback});
  }
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Speed");
  ImGui::SameLine(0.0F, 6.0F);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(fmt::format("{:.2f}\xc3\x97", playback.speed).c_str());
}

}  // namespace

void showTimeline(const AppState& state, const Layout& layout, Commands& commands) {
  const Palette& palette = paletteFor(state.view.dark);
  const auto width = static_cast<float>(layout.viewport.width) - 28.0F;
  const auto height = static_cast<float>(layout.viewport.height);
  ImGui::SetNextWindowPos(ImVec2(14.0F, height - 14.0F), ImGuiCond_Always, ImVec2(0.0F, 1.0F));
  ImGui::SetNextWindowSize(ImVec2(width, layout.narrow() ? 96.0F : 62.0F));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(10.0F, 9.0F));
  ImGui::Begin("Timeline", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  ImGui::SetCursorPosY(layout.narrow() ? 6.0F : 14.0F);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(2.0F, 2.0F));
  showButtons(state, palette, commands);
  ImGui::SameLine(0.0F, 10.0F);
  ImGui::BeginGroup();
  ImGui::Dummy(ImVec2(0.0F, 1.0F));
  showSpeed(state, commands);
  ImGui::EndGroup();
  ImGui::PopStyleVar();
  ImGui::SameLine(0.0F, 14.0F);
  const double shown = state.canPlay() ? state.shownSeconds() : 0.0;
  const std::string clock = fmt::format("{:.2f} / {:.2f} s", shown, state.walkSeconds());
  const float clockWidth = ImGui::CalcTextSize("00.00 / 00.00 s").x;
  ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddText(ImVec2(corner.x, corner.y + 9.0F), asImU32(palette.quietText),
                                      clock.c_str());
  const ImVec2 window = ImGui::GetWindowPos();
  corner = layout.narrow() ? ImVec2(window.x + 14.0F, window.y + 54.0F)
                           : ImVec2(corner.x + clockWidth + 14.0F, window.y + 16.0F);
  // As long as the longest walk; the bars are the first walker's.
  const std::size_t frames =
      state.canPlay() ? 1 + static_cast<std::size_t>(
                                std::lround(state.walkSeconds() * state.library->frames.framesPerSecond))
                      : 1;
  const Track track{corner, std::max(40.0F, window.x + width - 16.0F - corner.x), frames};
  scrub(state, track, commands);
  drawTrack(state, palette, track);
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace stridegraph
