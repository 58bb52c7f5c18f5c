#pragma once

#include <imgui.h>

#include <span>

#include "render/palette.h"

namespace stridegraph {

ImVec4 asImVec4(const Colour& colour);
ImU32 asImU32(const Colour& colour);

/// Rounded, calm, one accent colour; the same measures in both appearances.
void applyStyle(const Palette& palette);

/// Bakes the page's font for a pixel ratio; without font bytes ImGui's own is scaled. The bytes must outlive
/// the context.
void bakeFonts(std::span<const unsigned char> fontFile, float pixelRatio);

}  // namespace stridegraph
