#include "state/text_runs.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace stridegraph {

namespace {

constexpr char32_t kReplacement = 0xFFFD;

struct Range {
  char32_t first, last;
};

// Blocks of The Unicode Standard, chapter 24.
constexpr std::array<Range, 11> kMarks = {{{0x300, 0x36F},        // combining diacritical marks
                                           {0x1AB0, 0x1AFF},      // extended
                                           {0x1DC0, 0x1DFF},      // supplement
                                           {0x200D, 0x200D},      // zero width joiner
                                           {0x20D0, 0x20FF},      // for symbols, with the enclosing keycap
                                           {0x3099, 0x309A},      // kana voiced sound marks
                                           {0xFE00, 0xFE0F},      // variation selectors
                                           {0xFE20, 0xFE2F},      // combining half marks
                                           {0x1F3FB, 0x1F3FF},    // skin tones
                                           {0xE0020, 0xE007F},    // tags
                                           {0xE0100, 0xE01EF}}};  // variation selectors supplement
constexpr std::array<Range, 5> kAnywhereBreaking = {{{0x2E80, 0x9FFF},  // radicals to ideographs, with kana
                                                     {0xAC00, 0xD7A3},  // Hangul syllables
                                                     {0xF900, 0xFAFF},  // compatibility ideographs
                                                     {0xFF00, 0xFFEF},  // full width forms
                                                     {0x20000, 0x3FFFF}}};  // planes of ideographs
constexpr std::array<Range, 4> kRightToLeft = {{{0x590, 0x8FF},             // Hebrew to Arabic extended
                                                {0xFB1D, 0xFDFF},           // presentation forms
                                                {0xFE70, 0xFEFF},           // Arabic presentation forms B
                                                {0x10800, 0x10FFF}}};  // historic scripts, Adlam's neighbours

template <std::size_t count>
bool isIn(const std::array<Range, count>& ranges, char32_t codePoint) {
  return std::any_of(ranges.begin(), ranges.end(), [codePoint](const Range& range) {
    return codePoint >= range.first && codePoint <= range.last;
  });
}

bool isContinuation(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

struct Character {
  std::size_t begin = 0, end = 0;  ///< Bytes, combining marks included.
  char32_t codePoint = 0;          ///< Of the base.
  bool inFont = true;
};

/// The code point at `at`, which is moved behind it.
char32_t decode(std::string_view text, std::size_t& at) {
  const auto lead = static_cast<unsigned char>(text[at++]);
  if (lead < 0x80) return lead;
  const unsigned length = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : lead >= 0xC0 ? 1 : 0;
  char32_t codePoint = lead & (0x3FU >> length);
  unsigned read = 0;
  for (; read < length && at < text.size() && isContinuation(text[at]); ++read, ++at)
    codePoint = codePoint << 6U | (static_cast<unsigned char>(text[at]) & 0x3FU);
  return length > 0 && read == length ? codePoint : kReplacement;
}

std::vector<Character> charactersOf(std::string_view text, const std::function<bool(char32_t)>& inFont) {
  std::vector<Character> characters;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = at;
    const char32_t codePoint = decode(text, at);
    const bool extends = isIn(kMarks, codePoint) && !characters.empty();
    if (!extends) {
      characters.push_back({begin, at, codePoint, inFont(codePoint)});
      continue;
    }
    characters.back().end = at;
    characters.back().inFont = false;  // Fonts are drawn character by character here, which cannot combine.
  }
  return characters;
}

/// Takes in what stands between words that are written from right to left, line by line.
void joinRightToLeft(std::vector<Character>& characters) {
  const auto isRight = [](const Character& each) { return isIn(kRightToLeft, each.codePoint); };
  const auto isBreak = [](const Character& each) { return each.codePoint == U'\n'; };
  for (auto line = characters.begin(); line != characters.end();) {
    const auto end = std::find_if(line, characters.end(), isBreak);
    const auto first = std::find_if(line, end, isRight);
    auto last = end;
    while (last != first && !isRight(*(last - 1))) --last;
    for (auto each = first; each != last; ++each) each->inFont = false;
    line = end == characters.end() ? end : end + 1;
  }
}

}  // namespace

std::vector<TextRun> splitRuns(std::string_view text, const std::function<bool(char32_t)>& inFont) {
  std::vector<Character> characters = charactersOf(text, inFont);
  joinRightToLeft(characters);
  std::vector<TextRun> runs;
  bool mayGrow = false;
  for (const Character& each : characters) {
    const std::size_t size = each.end - each.begin;
    const bool alone = !each.inFont && isIn(kAnywhereBreaking, each.codePoint);
    if (mayGrow && !alone && runs.back().inFont == each.inFont) {
      runs.back().text = {runs.back().text.data(), runs.back().text.size() + size};
    } else {
      runs.push_back({text.substr(each.begin, size), each.inFont});
    }
    mayGrow = !alone;
  }
  return runs;
}

std::string shortened(std::string_view text, std::size_t mostCodePoints) {
  std::size_t at = 0;
  for (std::size_t taken = 0; taken < mostCodePoints && at < text.size(); ++taken) decode(text, at);
  if (at >= text.size()) return std::string(text);
  return std::string(text.substr(0, at)) + "\xe2\x80\xa6";
}

}  // namespace stridegraph
