#include "ui/style.h"

namespace stridegraph {

namespace {

Colour over(const Colour& base, const Colour& top, float share) {
  return {base.red + (top.red - base.red) * share, base.green + (top.green - base.green) * share,
          base.blue + (top.blue - base.blue) * share, 1.0F};
}

void setMeasures(ImGuiStyle& style) {
  style.WindowRounding = 12.0F;
  style.ChildRounding = 8.0F;
  style.FrameRounding = 7.0F;
  style.PopupRounding = 8.0F;
  style.GrabRounding = 6.0F;
  style.ScrollbarRounding = 6.0F;
  style.WindowPadding = ImVec2(14.0F, 12.0F);
  style.FramePadding = ImVec2(9.0F, 5.0F);
  style.ItemSpacing = ImVec2(8.0F, 7.0F);
  style.ItemInnerSpacing = ImVec2(6.0F, 5.0F);
  style.ScrollbarSize = 9.0F;
  style.GrabMinSize = 12.0F;
  style.WindowBorderSize = 1.0F;
  style.PopupBorderSize = 1.0F;
  style.FrameBorderSize = 0.0F;
}

}  // namespace

ImVec4 asImVec4(const Colour& colour) {
  return {colour.red, colour.green, colour.blue, colour.alpha};
}

ImU32 asImU32(const Colour& colour) {
  return ImGui::ColorConvertFloat4ToU32(asImVec4(colour));
}

void applyStyle(const Palette& palette) {
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  setMeasures(style);
  ImVec4* colours = style.Colors;
  const Colour solid = palette.panel.faded(1.0F / palette.panel.alpha);
  const Colour& accent = palette.accent;
  colours[ImGuiCol_Text] = asImVec4(palette.text);
  colours[ImGuiCol_TextDisabled] = asImVec4(palette.quietText);
  colours[ImGuiCol_WindowBg] = asImVec4(palette.panel);
  colours[ImGuiCol_PopupBg] = asImVec4(solid);
  colours[ImGuiCol_Border] = asImVec4(palette.panelEdge);
  colours[ImGuiCol_FrameBg] = colours[ImGuiCol_Button] = asImVec4(palette.control);
  colours[ImGuiCol_FrameBgHovered] = colours[ImGuiCol_ButtonHovered] = asImVec4(accent.faded(0.18F));
  colours[ImGuiCol_FrameBgActive] = colours[ImGuiCol_ButtonActive] = asImVec4(accent.faded(0.30F));
  colours[ImGuiCol_Header] = asImVec4(accent.faded(0.16F));
  colours[ImGuiCol_HeaderHovered] = asImVec4(accent.faded(0.22F));
  colours[ImGuiCol_HeaderActive] = asImVec4(accent.faded(0.30F));
  colours[ImGuiCol_CheckMark] = colours[ImGuiCol_SliderGrab] = asImVec4(accent);
  colours[ImGuiCol_SliderGrabActive] = asImVec4(over(accent, palette.text, 0.2F));
  colours[ImGuiCol_Separator] = asImVec4(palette.panelEdge);
  colours[ImGuiCol_ScrollbarBg] = ImVec4(0.0F, 0.0F, 0.0F, 0.0F);
  colours[ImGuiCol_ScrollbarGrab] = asImVec4(palette.control.faded(2.0F));
  colours[ImGuiCol_TextSelectedBg] = asImVec4(accent.faded(0.35F));
  colours[ImGuiCol_NavHighlight] = asImVec4(accent);
}

}  // namespace stridegraph
