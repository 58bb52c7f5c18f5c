#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace stridegraph {

/// A stretch of a text, UTF-8.
struct TextRun {
  std::string_view text;
  /// Whether the font holds each of its characters, so that it may be drawn one character after the other.
  /// Otherwise it is drawn as one picture, by somebody who knows its script.
  bool inFont = true;
};

/// Splits a text into runs, which in their order are the whole of it. A run outside the font is a single
/// character where lines may break at every character (Chinese, Japanese, Korean), else a word; words written
/// from right to left are one run with what stands between them, since their order on screen is another. A
/// combining mark goes with the character before it. `inFont` tells whether the font holds a code point.
std::vector<TextRun> splitRuns(std::string_view text, const std::function<bool(char32_t)>& inFont);

/// The text when it has at most so many code points, else its beginning and an ellipsis.
std::string shortened(std::string_view text, std::size_t mostCodePoints);

}  // namespace stridegraph
