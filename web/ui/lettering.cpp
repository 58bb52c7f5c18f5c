#include "ui/lettering.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "base/utf8.h"
#include "state/text_runs.h"

namespace stridegraph {

namespace {

constexpr float kTextPoints = 14.5F;
// Pictures stand for characters of the private use area, of which texts never reach ImGui themselves.
constexpr std::size_t kFirstPicture = 0xE000;
constexpr std::size_t kMostPictures = 2000;
constexpr std::size_t kMostArea = std::size_t{2048} * 1024;  // Device pixels.
constexpr std::size_t kMostTexts = 64;
/// Wider than any picture, so that each finds room.
constexpr int kAtlasWidth = 2048;
constexpr int kWidestPicture = kAtlasWidth - 8;

bool fontHolds(char32_t codePoint) {
  if (codePoint < U' ') return true;  // Line breaks and the like are no glyphs.
  if (codePoint > IM_UNICODE_CODEPOINT_MAX) return false;
  if (codePoint >= kFirstPicture && codePoint < kFirstPicture + kMostPictures) return false;
  const ImFont* const font = ImGui::GetIO().Fonts->Fonts[0];
  return font->FindGlyphNoFallback(static_cast<ImWchar>(codePoint)) != nullptr;
}

void addFont(std::span<const unsigned char> file, float pixels) {
  static const ImWchar kRanges[] = {0x20,   0x7e,   0xa0,   0x17f,  0x370,  0x3ff,  0x400,  0x4ff, 0x1e00,
                                    0x1eff, 0x2010, 0x2026, 0x2190, 0x2193, 0x2212, 0x2212, 0};
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  ImFontConfig config;
  config.OversampleH = 2;
  config.OversampleV = 1;
  if (file.empty()) {
    config.SizePixels = pixels;
    atlas.AddFontDefault(&config);
    return;
  }
  config.FontDataOwnedByAtlas = false;
  // ImGui only reads them, whatever its signature says.
  void* const bytes = const_cast<unsigned char*>(file.data());
  atlas.AddFontFromMemoryTTF(bytes, static_cast<int>(file.size()), pixels, &config, kRanges);
}

bool isUsable(const TextPicture& picture) {
  return picture.width > 0 && picture.height > 0 && picture.width <= kWidestPicture &&
         picture.height <= kAtlasWidth &&
         picture.rgba.size() ==
             static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height) * 4;
}

std::size_t areaOf(const TextPicture& picture) {
  return picture.rgba.size() / 4;
}

/// Copies a picture to its place in the atlas.
void paint(const TextPicture& picture, const ImFontAtlasCustomRect& place) {
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  const std::size_t row = static_cast<std::size_t>(picture.width) * 4;
  for (std::size_t y = 0; y < static_cast<std::size_t>(picture.height); ++y) {
    const std::size_t at = (place.Y + y) * static_cast<std::size_t>(width) + place.X;
    std::memcpy(pixels + at * 4, picture.rgba.data() + y * row, row);
  }
}

}  // namespace

void Lettering::bake(std::span<const unsigned char> fontFile, float pixelRatio) {
  fontFile_ = fontFile;
  pixelRatio_ = pixelRatio;
  glyphs_.clear();
  wanted_.clear();
  rebake();
}

void Lettering::rebake() {
  ImGuiIO& io = ImGui::GetIO();
  ImFontAtlas& atlas = *io.Fonts;
  atlas.Clear();
  texts_.clear();
  addFont(fontFile_, std::round(kTextPoints * pixelRatio_));
  io.FontGlobalScale = 1.0F / pixelRatio_;
  ImFont* const font = atlas.Fonts[0];
  std::vector<std::pair<int, const Glyph*>> placed;
  for (const auto& [run, glyph] : glyphs_) {
    if (!glyph) continue;
    const TextPicture& picture = glyph->picture;
    const int place = atlas.AddCustomRectFontGlyph(font, glyph->codePoint, picture.width, picture.height,
                                                   picture.advance, ImVec2(-picture.left, -picture.ascent));
    placed.emplace_back(place, &*glyph);
  }
  if (!placed.empty()) atlas.TexDesiredWidth = kAtlasWidth;
  atlas.Build();
  for (const auto& [place, glyph] : placed) {
    paint(glyph->picture, *atlas.GetCustomRectByIndex(place));
    // Where the baseline lies is known only now.
    auto& baked = const_cast<ImFontGlyph&>(*font->FindGlyphNoFallback(glyph->codePoint));
    const float baseline = std::round(font->Ascent);
    baked.Y0 += baseline;
    baked.Y1 += baseline;
    baked.Colored = glyph->picture.coloured ? 1U : 0U;
  }
}

bool Lettering::drawWanted(const DrawText& draw) {
  if (wanted_.empty()) return false;
  const float pixels = std::round(kTextPoints * pixelRatio_);
  std::vector<std::pair<std::string, std::optional<TextPicture>>> drawn;
  std::size_t area = 0;
  for (std::string& run : std::exchange(wanted_, {})) {
    std::optional<TextPicture> picture = draw ? draw(run, pixels) : std::nullopt;
    if (picture && !isUsable(*picture)) picture.reset();
    if (picture) area += areaOf(*picture);
    drawn.emplace_back(std::move(run), std::move(picture));
  }
  for (const auto& [run, glyph] : glyphs_) area += glyph ? areaOf(glyph->picture) : 0;
  // What is still on screen asks again.
  if (area > kMostArea || glyphs_.size() + drawn.size() > kMostPictures) glyphs_.clear();
  keep(std::move(drawn));
  rebake();
  return true;
}

void Lettering::keep(std::vector<std::pair<std::string, std::optional<TextPicture>>> drawn) {
  std::size_t area = 0;
  for (auto& [run, picture] : drawn) {
    const std::size_t index = glyphs_.size();
    std::optional<Glyph>& glyph = glyphs_[run];
    if (!picture || index >= kMostPictures || area + areaOf(*picture) > kMostArea) continue;
    area += areaOf(*picture);
    glyph = Glyph{static_cast<ImWchar>(kFirstPicture + index), *std::move(picture)};
  }
}

std::vector<std::string> Lettering::missing() const {
  std::vector<std::string> runs;
  for (const auto& [run, glyph] : glyphs_) {
    if (!glyph) runs.push_back(run);
  }
  return runs;
}

std::string Lettering::shown(std::string_view text) {
  const auto known = texts_.find(text);
  if (known != texts_.end()) return known->second;
  if (texts_.size() >= kMostTexts) texts_.clear();
  std::string answer = composed(text);
  return texts_.emplace(text, std::move(answer)).first->second;
}

std::string Lettering::composed(std::string_view text) {
  std::string answer;
  for (const TextRun& run : splitRuns(text, fontHolds)) {
    const auto known = glyphs_.find(run.text);
    if (run.inFont || (known != glyphs_.end() && !known->second)) {
      answer += run.text;
    } else if (known != glyphs_.end()) {
      appendUtf8(known->second->codePoint, answer);
    } else if (std::find(wanted_.begin(), wanted_.end(), run.text) == wanted_.end()) {
      wanted_.emplace_back(run.text);
    }
  }
  return answer;
}

}  // namespace stridegraph
