#pragma once

#include <imgui.h>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stridegraph {

/// Text as somebody draws it who knows every script: white on nothing, device pixels.
struct TextPicture {
  int width = 0, height = 0;
  float left = 0.0F;               ///< From the picture's left edge to where the text begins.
  float ascent = 0.0F;             ///< From the picture's upper edge to the baseline.
  float advance = 0.0F;            ///< From where the text begins to where the next one does.
  bool coloured = false;           ///< An emoji keeps its own colours.
  std::vector<std::uint8_t> rgba;  ///< height x width x 4, from the upper left.
};

/// Draws a text in the size of the app's text, in device pixels; empty where it cannot.
using DrawText = std::function<std::optional<TextPicture>(const std::string& text, float pixels)>;

/// Text of any script for ImGui, whose font atlas holds Latin, Greek and Cyrillic: every other run of
/// characters (splitRuns) becomes one glyph of its own, drawn by the host. Needs an ImGui context.
class Lettering {
 public:
  /// Bakes the font for a pixel ratio, anew and without pictures; without font bytes ImGui's own is scaled.
  /// The bytes must outlive the context. The texture is the caller's to upload.
  void bake(std::span<const unsigned char> fontFile, float pixelRatio);

  /// Draws what shown() has asked for since the last call, and bakes again. Whether the texture is another
  /// now.
  bool drawWanted(const DrawText& draw);
  /// Whether there is something for drawWanted().
  bool isWaiting() const { return !wanted_.empty(); }

  /// Runs that were asked for and that nobody can draw.
  std::vector<std::string> missing() const;

  /// A text as ImGui has to be given it. Runs that nobody has drawn yet are left out until the next frame;
  /// those that nobody can draw stay as they are, and ImGui shows question marks.
  std::string shown(std::string_view text);

 private:
  struct Glyph {
    ImWchar codePoint = 0;
    TextPicture picture;
  };

  void rebake();
  void keep(std::vector<std::pair<std::string, std::optional<TextPicture>>> drawn);
  std::string composed(std::string_view text);

  std::span<const unsigned char> fontFile_;
  float pixelRatio_ = 1.0F;
  std::map<std::string, std::optional<Glyph>, std::less<>> glyphs_;  ///< Empty where nobody can draw the run.
  std::map<std::string, std::string, std::less<>> texts_;            ///< What shown() has answered.
  std::vector<std::string> wanted_;
};

}  // namespace stridegraph
