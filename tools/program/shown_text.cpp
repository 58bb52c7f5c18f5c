#include "program/shown_text.h"

#include <fmt/format.h>

#include "base/utf8.h"

namespace stridegraph::tools {
namespace {

constexpr std::size_t kLongestQuote = 60;
constexpr unsigned char kDelete = 0x7F;

/// Whether the two bytes are one of the control characters U+0080 to U+009F.
bool isHighControl(unsigned char first, unsigned char second) {
  return first == 0xC2 && second >= 0x80 && second <= 0x9F;
}

std::string withoutControls(std::string_view bytes, bool keepLines) {
  const std::string text = toUtf8(bytes);
  std::string shown;
  shown.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto letter = static_cast<unsigned char>(text[i]);
    const bool isLine = text[i] == '\n' || text[i] == '\t';
    const bool isHigh = i + 1 < text.size() && isHighControl(letter, static_cast<unsigned char>(text[i + 1]));
    const bool isControl = isHigh || letter == kDelete || (letter < ' ' && !(keepLines && isLine));
    if (isControl)
      appendUtf8(0xFFFD, shown);
    else
      shown += text[i];
    if (isHigh) ++i;
  }
  return shown;
}

}  // namespace

std::string shownText(std::string_view bytes) {
  return withoutControls(bytes, false);
}

std::string quotedText(std::string_view bytes) {
  std::string text = shownText(bytes.substr(0, 4 * kLongestQuote));
  if (text.size() > kLongestQuote) {
    std::size_t end = kLongestQuote;
    // A letter of several bytes is not cut.
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
    text = text.substr(0, end) + "...";
  }
  const bool isPlain = !text.empty() && text.find(' ') == std::string::npos;
  return isPlain ? text : fmt::format("\"{}\"", text);
}

void print(std::FILE* stream, std::string_view text) {
  const std::string shown = withoutControls(text, true);
  std::fwrite(shown.data(), 1, shown.size(), stream);
}

void printLine(std::FILE* stream, std::string_view text) {
  print(stream, fmt::format("{}\n", text));
}

bool finishOutput() {
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
}

}  // namespace stridegraph::tools
