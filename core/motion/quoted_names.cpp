#include "motion/quoted_names.h"

#include <fmt/format.h>

namespace stridegraph {

std::string quotedNames(std::span<const std::string> names) {
  constexpr std::size_t kMostInFull = 4;
  constexpr std::size_t kNamedOfMany = 3;
  const std::size_t named = names.size() <= kMostInFull ? names.size() : kNamedOfMany;
  std::string text;
  for (std::size_t i = 0; i < named; ++i) {
    const bool isLast = i + 1 == names.size();
    text += fmt::format("{}\"{}\"", i == 0 ? "" : isLast ? " and " : ", ", names[i]);
  }
  if (named < names.size()) text += fmt::format(" and {} more", names.size() - named);
  return text;
}

}  // namespace stridegraph
