#include "ui/style.h"

#include <cmath>

namespace stridegraph {

namespace {

constexpr float kTextPoints = 14.5F;

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

void bakeFonts(std::span<const unsigned char> fontFile, float pixelRatio) {
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->Clear();
  ImFontConfig config;
  config.OversampleH = 2;
  config.OversampleV = 1;
  const float pixels = std::round(kTextPoints * pixelRatio);
  static const ImWchar kRanges[] = {0x20,   0x7e,   0xa0,   0x17f,  0x2010, 0x2026,
                                    0x2190, 0x2193, 0x2212, 0x2212, 0};
  if (fontFile.empty()) {
    config.SizePixels = pixels;
    io.Fonts->AddFontDefault(&config);
  } else {
    config.FontDataOwnedByAtlas = false;
    // ImGui only reads them, whatever its signature says.
    void* bytes = const_cast<unsigned char*>(fontFile.data());
    io.Fonts->AddFontFromMemoryTTF(bytes, static_cast<int>(fontFile.size()), pixels, &config, kRanges);
  }
  io.FontGlobalScale = 1.0F / pixelRatio;
  io.Fonts->Build();
}

}  // namespace stridegraph
