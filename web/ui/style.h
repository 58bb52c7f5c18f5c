#pragma once

#include <imgui.h>

#include "render/palette.h"

namespace stridegraph {

ImVec4 asImVec4(const Colour& colour);
ImU32 asImU32(const Colour& colour);

/// Rounded, calm, one accent colour; the same measures in both appearances.
void applyStyle(const Palette& palette);

}  // namespace stridegraph
