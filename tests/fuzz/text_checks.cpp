#include "text_checks.h"

#include <algorithm>
#include <string>

#include "base/utf8.h"
#include "target.h"

namespace stridegraph::fuzz {
namespace {

bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c & 0x80) != 0;
}

/// Whether the word stands there on its own.
bool hasWord(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !isLetter(text[at - 1])) && (end == text.size() || !isLetter(text[end]))) return true;
  }
  return false;
}

void requireSound(std::string_view message, const Place& place, std::size_t lines) {
  require(!message.empty(), "a message says something");
  require(isUtf8(message), "a message is UTF-8");
  require(isUtf8(place.file), "the name of a file in a message is UTF-8");
  require(place.line <= lines, "a message names a line that there is");
}

}  // namespace

void requireSentence(std::string_view sentence) {
  require(!sentence.empty(), "a message says something");
  require(isUtf8(sentence), "a message is UTF-8");
  for (const std::string_view word : {"inf", "nan"})
    require(!hasWord(sentence, word), "a sentence holds real numbers: " + std::string(sentence));
}

void requireSound(const Error& error, std::size_t lines) {
  requireSound(error.message, error.place, lines);
}

void requireSound(const Warnings& warnings, std::size_t lines) {
  for (const Warning& warning : warnings) requireSound(warning.message, warning.place, lines);
}

std::size_t mostLines(std::string_view text) {
  const auto ends = std::count_if(text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; });
  return static_cast<std::size_t>(ends) + 1;
}

}  // namespace stridegraph::fuzz
