#include "motion/mirror_names.h"

#include <array>
#include <utility>

namespace stridegraph {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kWords = {
    {{"left", "right"}, {"Left", "Right"}, {"LEFT", "RIGHT"}}};

bool isLetterOrDigit(char c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

char otherSide(char c) {
  switch (c) {
    case 'l':
      return 'r';
    case 'r':
      return 'l';
    case 'L':
      return 'R';
    case 'R':
      return 'L';
    default:
      return '\0';
  }
}

void addSwappedWords(std::string_view name, std::string_view from, std::string_view to,
                     std::vector<std::string>& names) {
  for (std::size_t at = name.find(from); at != std::string_view::npos; at = name.find(from, at + 1)) {
    std::string other(name);
    names.push_back(other.replace(at, from.size(), to));
  }
}

}  // namespace

std::vector<std::string> mirroredNames(std::string_view name) {
  std::vector<std::string> names;
  for (const auto& [left, right] : kWords) {
    addSwappedWords(name, left, right, names);
    addSwappedWords(name, right, left, names);
  }
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char other = otherSide(name[i]);
    if (other == '\0') continue;
    const bool isFirst = i == 0 || !isLetterOrDigit(name[i - 1]);
    const bool isLast = i + 1 == name.size() || !isLetterOrDigit(name[i + 1]);
    const bool isCapitalAtTheEnd = i + 1 == name.size() && other <= 'Z';
    const bool isPrefix = i == 0;
    if (!isPrefix && !isCapitalAtTheEnd && !(isFirst && isLast)) continue;
    std::string swapped(name);
    swapped[i] = other;
    names.push_back(std::move(swapped));
  }
  return names;
}

}  // namespace stridegraph
