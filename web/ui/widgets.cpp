#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/style.h"

namespace stridegraph {

namespace {

/// A pen on a square of -1..1 around the icon's middle.
struct Pen {
  ImDrawList& list;
  ImVec2 middle;
  float half;
  ImU32 colour;
  float width;

  ImVec2 at(float x, float y) const { return {middle.x + x * half, middle.y + y * half}; }
  void line(float x0, float y0, float x1, float y1) const {
    list.AddLine(at(x0, y0), at(x1, y1), colour, width);
  }
  void fill(ImVec2 a, ImVec2 b, ImVec2 c) const {
    list.AddTriangleFilled(at(a.x, a.y), at(b.x, b.y), at(c.x, c.y), colour);
  }
  void bar(float x0, float y0, float x1, float y1, float round = 1.0F) const {
    list.AddRectFilled(at(x0, y0), at(x1, y1), colour, round);
  }
  void arc(float radius, float from, float to) const {
    list.PathArcTo(middle, radius * half, from, to, 20);
    list.PathStroke(colour, 0, width);
  }
  void ring(float radius) const { list.AddCircle(middle, radius * half, colour, 24, width); }
  void dot(float radius) const { list.AddCircleFilled(middle, radius * half, colour, 20); }
};

constexpr float kFieldLeft = 92.0F;
constexpr float kPi = std::numbers::pi_v<float>;

void drawTurn(const Pen& pen, float side) {
  pen.arc(0.62F, side > 0 ? -kPi * 0.95F : kPi * 0.0F - kPi * 0.95F, side > 0 ? kPi * 0.35F : kPi * 0.35F);
  pen.fill({-0.98F * side, -0.28F}, {-0.28F * side, -0.28F}, {-0.63F * side, 0.22F});
}

void drawPlayIcon(const Pen& pen, Icon icon) {
  switch (icon) {
    case Icon::kPlay:
      pen.fill({-0.5F, -0.75F}, {-0.5F, 0.75F}, {0.78F, 0.0F});
      break;
    case Icon::kPause:
      pen.bar(-0.58F, -0.7F, -0.16F, 0.7F);
      pen.bar(0.16F, -0.7F, 0.58F, 0.7F);
      break;
    case Icon::kToStart:
      pen.bar(-0.75F, -0.65F, -0.5F, 0.65F);
      pen.fill({0.7F, -0.65F}, {0.7F, 0.65F}, {-0.4F, 0.0F});
      break;
    case Icon::kStepBack:
      pen.bar(0.45F, -0.6F, 0.68F, 0.6F);
      pen.fill({0.25F, -0.6F}, {0.25F, 0.6F}, {-0.65F, 0.0F});
      break;
    case Icon::kStepOn:
      pen.bar(-0.68F, -0.6F, -0.45F, 0.6F);
      pen.fill({-0.25F, -0.6F}, {-0.25F, 0.6F}, {0.65F, 0.0F});
      break;
    default:
      break;
  }
}

void drawCameraIcon(const Pen& pen, Icon icon) {
  switch (icon) {
    case Icon::kOrbit:
      pen.list.AddCircleFilled(pen.at(0.0F, 0.0F), 0.24F * pen.half, pen.colour, 16);
      pen.ring(0.75F);
      break;
    case Icon::kFollow:
      pen.list.AddCircleFilled(pen.at(0.0F, -0.55F), 0.26F * pen.half, pen.colour, 16);
      pen.line(0.0F, -0.25F, 0.0F, 0.25F);
      pen.line(0.0F, 0.2F, -0.38F, 0.8F);
      pen.line(0.0F, 0.2F, 0.38F, 0.8F);
      break;
    case Icon::kTop:
      pen.list.AddRect(pen.at(-0.7F, -0.7F), pen.at(0.7F, 0.7F), pen.colour, 2.0F, 0, pen.width);
      pen.line(0.0F, -0.7F, 0.0F, 0.7F);
      pen.line(-0.7F, 0.0F, 0.7F, 0.0F);
      break;
    case Icon::kWhole:
      for (const float x : {-1.0F, 1.0F}) {
        for (const float y : {-1.0F, 1.0F}) {
          pen.line(0.72F * x, 0.72F * y, 0.25F * x, 0.72F * y);
          pen.line(0.72F * x, 0.72F * y, 0.72F * x, 0.25F * y);
        }
      }
      break;
    default:
      break;
  }
}

void drawToolIcon(const Pen& pen, Icon icon) {
  switch (icon) {
    case Icon::kSelect:
      pen.fill({-0.5F, -0.8F}, {-0.5F, 0.5F}, {0.45F, 0.14F});
      pen.line(-0.1F, 0.1F, 0.28F, 0.8F);
      break;
    case Icon::kBlock:
      pen.bar(-0.75F, -0.5F, 0.75F, 0.5F, 2.0F);
      break;
    case Icon::kMoving:
      pen.bar(-0.35F, -0.62F, 0.35F, 0.08F, 2.0F);
      pen.line(-0.5F, 0.58F, 0.5F, 0.58F);
      pen.fill({-0.95F, 0.58F}, {-0.45F, 0.26F}, {-0.45F, 0.90F});
      pen.fill({0.95F, 0.58F}, {0.45F, 0.26F}, {0.45F, 0.90F});
      break;
    case Icon::kArea:
      pen.list.AddRect(pen.at(-0.8F, -0.6F), pen.at(0.8F, 0.6F), pen.colour, 2.0F, 0, pen.width);
      pen.line(-0.5F, 0.5F, 0.1F, -0.5F);
      pen.line(0.0F, 0.5F, 0.6F, -0.5F);
      break;
    case Icon::kWalker:
      pen.list.AddCircleFilled(pen.at(-0.28F, -0.58F), 0.26F * pen.half, pen.colour, 16);
      pen.line(-0.28F, -0.25F, -0.28F, 0.25F);
      pen.line(-0.28F, 0.2F, -0.62F, 0.8F);
      pen.line(-0.28F, 0.2F, 0.06F, 0.8F);
      pen.line(0.62F, -0.42F, 0.62F, 0.18F);
      pen.line(0.32F, -0.12F, 0.92F, -0.12F);
      break;
    case Icon::kStart:
      pen.ring(0.72F);
      pen.fill({-0.25F, -0.38F}, {-0.25F, 0.38F}, {0.42F, 0.0F});
      break;
    case Icon::kGoal:
      pen.ring(0.72F);
      pen.dot(0.3F);
      break;
    case Icon::kUndo:
      drawTurn(pen, 1.0F);
      break;
    case Icon::kRedo:
      drawTurn(pen, -1.0F);
      break;
    case Icon::kDelete:
      pen.line(-0.55F, -0.55F, 0.55F, 0.55F);
      pen.line(-0.55F, 0.55F, 0.55F, -0.55F);
      break;
    case Icon::kLoop:
      pen.arc(0.68F, -kPi * 0.35F, kPi * 1.2F);
      pen.fill({0.02F, -0.98F}, {0.02F, -0.24F}, {0.6F, -0.66F});
      break;
    default:
      break;
  }
}

}  // namespace

void drawIcon(ImDrawList& list, Icon icon, ImVec2 middle, float size, ImU32 colour) {
  const Pen pen{list, middle, size / 2.0F, colour, std::max(1.5F, size / 9.0F)};
  drawToolIcon(pen, icon);
  drawPlayIcon(pen, icon);
  drawCameraIcon(pen, icon);
}

bool iconButton(const IconButton& button, const Palette& palette) {
  constexpr float kSize = 34.0F;
  constexpr float kIcon = 15.0F;
  const float text = button.label ? ImGui::CalcTextSize(button.label).x + 10.0F : 0.0F;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 size(kSize + text, kSize);
  const bool pressed = ImGui::InvisibleButton(button.id, size) && button.enabled;
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 far(corner.x + size.x, corner.y + size.y);
  Colour ink = button.enabled ? palette.text : palette.quietText.faded(0.4F);
  if (button.chosen) {
    list.AddRectFilled(corner, far, asImU32(palette.accent), 8.0F);
    ink = Colour::hex(palette.text.red > 0.5F ? 0x10151d : 0xffffff);
  } else if (hovered && button.enabled) {
    list.AddRectFilled(corner, far, asImU32(palette.accent.faded(ImGui::IsItemActive() ? 0.30F : 0.16F)),
                       8.0F);
  }
  drawIcon(list, button.icon, ImVec2(corner.x + kSize / 2, corner.y + kSize / 2), kIcon, asImU32(ink));
  if (button.label) {
    const float y = corner.y + (kSize - ImGui::GetFontSize()) / 2;
    list.AddText(ImVec2(corner.x + kSize - 3.0F, y), asImU32(ink), button.label);
  }
  if (hovered) ImGui::SetTooltip("%s", button.tooltip);
  return pressed;
}

void heading(const char* text, const Palette& palette) {
  ImGui::Dummy(ImVec2(0.0F, 1.0F));
  ImGui::PushStyleColor(ImGuiCol_Text, asImVec4(palette.quietText));
  ImGui::TextUnformatted(text);
  ImGui::PopStyleColor();
}

bool section(const char* text, bool openAtFirst, const Palette& palette) {
  ImGui::Dummy(ImVec2(0.0F, 1.0F));
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::PushID(text);
  bool* const open = ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("open"), openAtFirst);
  if (ImGui::InvisibleButton("section", ImVec2(width, ImGui::GetTextLineHeight()))) *open = !*open;
  const bool hovered = ImGui::IsItemHovered();
  ImGui::PopID();
  const ImU32 ink = asImU32(hovered ? palette.text : palette.quietText);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddText(corner, ink, text);
  const ImVec2 middle(corner.x + width - 9.0F, corner.y + ImGui::GetTextLineHeight() / 2.0F);
  const Pen pen{list, middle, 4.0F, ink, 1.5F};
  const float tip = *open ? 0.5F : -0.5F;
  pen.line(-1.0F, -tip, 0.0F, tip);
  pen.line(0.0F, tip, 1.0F, -tip);
  return *open;
}

void figure(const char* name, const std::string& value, const Palette& palette) {
  ImGui::TextColored(asImVec4(palette.quietText), "%s", name);
  const float width = ImGui::CalcTextSize(value.c_str()).x;
  ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
  ImGui::TextUnformatted(value.c_str());
}

bool figureLink(const char* name, const std::string& value, const char* tooltip, const Palette& palette) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, ImGui::GetTextLineHeight());
  figure(name, value, palette);
  const ImVec2 after = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(corner);
  const bool pressed = ImGui::InvisibleButton(name, size);
  if (ImGui::IsItemHovered()) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    ImGui::GetWindowDrawList()->AddRectFilled(corner, ImVec2(corner.x + size.x, corner.y + size.y),
                                              asImU32(palette.control), 3.0F);
    ImGui::SetTooltip("%s", tooltip);
  }
  ImGui::SetCursorScreenPos(after);
  return pressed;
}

int choiceOf(const char* label, int current, std::span<const char* const> names) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(label);
  ImGui::SameLine(kFieldLeft);
  ImGui::SetNextItemWidth(-1.0F);
  ImGui::PushID(label);
  ImGui::Combo("##choice", &current, names.data(), static_cast<int>(names.size()));
  ImGui::PopID();
  return current;
}

bool numberField(const NumberField& field, double& value) {
  ImGui::PushID(field.label);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(field.label);
  ImGui::SameLine(kFieldLeft);
  ImGui::SetNextItemWidth(-1.0F);
  const bool changed =
      ImGui::DragScalar("##value", ImGuiDataType_Double, &value, static_cast<float>(field.step), &field.low,
                        &field.high, field.format, ImGuiSliderFlags_AlwaysClamp);
  if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  ImGui::PopID();
  return changed;
}

}  // namespace stridegraph
