#include <fmt/format.h>

#include "state/editor.h"
#include "state/items.h"
#include "state/text_runs.h"
#include "state/track_edit.h"
#include "ui/panels.h"
#include "ui/style.h"

namespace stridegraph {

namespace {

constexpr std::size_t kMostNoticeCodePoints = 500;

ImVec2 asImVec2(const Vec2& point) {
  return {static_cast<float>(point.x()), static_cast<float>(point.y())};
}

void drawHandles(const AppState& state, const CameraView& view, const Palette& palette, ImDrawList& list) {
  const Scene& scene = state.shownScene();
  for (const PlacedHandle& placed : handlesOf(scene, state.selection)) {
    const std::optional<Vec2> at = view.project(placed.position);
    if (!at) continue;
    const ImVec2 middle = asImVec2(*at);
    const bool round = placed.handle.kind == HandleKind::kHeading;
    const float size = placed.handle.kind == HandleKind::kEdge ? 4.0F : 5.5F;
    const ImVec2 low(middle.x - size, middle.y - size), high(middle.x + size, middle.y + size);
    if (round) {
      const Placement& placement = *placementOf(scene, placed.handle.item);
      const std::optional<Vec2> from = view.project({placement.position.x(), 0.0, placement.position.y()});
      if (from) list.AddLine(asImVec2(*from), middle, asImU32(palette.accent.faded(0.7F)), 1.5F);
      list.AddCircleFilled(middle, 6.5F, IM_COL32_WHITE, 20);
      list.AddCircle(middle, 6.5F, asImU32(palette.accent), 20, 2.0F);
      continue;
    }
    list.AddRectFilled(low, high, IM_COL32_WHITE, 2.5F);
    list.AddRect(low, high, asImU32(palette.accent), 2.5F, 0, 1.8F);
  }
}

void drawLabel(const std::string& text, ImVec2 at, const Palette& palette, ImDrawList& list) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const ImVec2 low(at.x - 7.0F, at.y - 4.0F), high(at.x + size.x + 7.0F, at.y + size.y + 4.0F);
  list.AddRectFilled(low, high, asImU32(palette.panel), 6.0F);
  list.AddRect(low, high, asImU32(palette.panelEdge), 6.0F);
  list.AddText(at, asImU32(palette.text), text.c_str());
}

std::string placeText(const Vec2& place) {
  return fmt::format("{:.2f}, {:.2f} m", place.x(), place.y());
}

/// What a drag makes of the item under the pointer, in figures.
std::string dragText(const Drag& drag) {
  const Scene& scene = drag.preview;
  const Item& item = drag.handle.item;
  if (const Rectangle* const rectangle = rectangleOf(scene, item)) {
    return drag.handle.kind == HandleKind::kBody
               ? placeText(rectangle->centre)
               : fmt::format("{:.2f} \xc3\x97 {:.2f} m", rectangle->size.x(), rectangle->size.y());
  }
  if (const Placement* const placement = placementOf(scene, item)) {
    return drag.handle.kind == HandleKind::kHeading && placement->heading
               ? fmt::format("{:.0f}\xc2\xb0", headingDegrees(*placement))
               : placeText(placement->position);
  }
  if (!isThere(scene, item)) return "";
  const MovingObstacle& moving = scene.moving[item.index];
  return fmt::format("{} at {:.1f} m/s", placeText(moving.track[drag.handle.point].position),
                     trackSpeed(moving));
}

void drawDragLabel(const AppState& state, const Palette& palette, ImDrawList& list) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  drawLabel(dragText(*state.drag), ImVec2(mouse.x + 18.0F, mouse.y + 14.0F), palette, list);
}

void drawNotice(const AppState& state, const Palette& palette, const Layout& layout, Lettering& lettering) {
  const std::string text = lettering.shown(shortened(state.notice.text, kMostNoticeCodePoints));
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  const float wrap = std::min(520.0F, static_cast<float>(layout.viewport.width) - 80.0F);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
  const float left = (static_cast<float>(layout.viewport.width) - size.x) / 2.0F;
  const float top = static_cast<float>(layout.viewport.height) - 112.0F - size.y;
  const ImVec2 low(left - 18.0F, top - 11.0F), high(left + size.x + 18.0F, top + size.y + 11.0F);
  const Colour& back = state.notice.problem ? palette.problem : palette.accent;
  const ImU32 ink = asImU32(Colour::hex(state.view.dark ? 0x10151d : 0xffffff));
  list.AddRectFilled(low, high, asImU32(back), 12.0F);
  list.AddText(nullptr, 0.0F, ImVec2(left, top), ink, text.c_str(), nullptr, wrap);
}

}  // namespace

void showOverlay(const AppState& state, const CameraView& view, const Layout& layout, Lettering& lettering) {
  const Palette& palette = paletteFor(state.view.dark);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  drawHandles(state, view, palette, list);
  if (state.drag && state.drag->moved) drawDragLabel(state, palette, list);
  if (!state.notice.text.empty() && state.nowSeconds < state.notice.untilSeconds) {
    drawNotice(state, palette, layout, lettering);
  }
}

}  // namespace stridegraph
