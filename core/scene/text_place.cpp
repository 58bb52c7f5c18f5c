#include "scene/text_place.h"

#include <algorithm>
#include <string>

namespace stridegraph {

Place placeInText(std::string_view text, std::size_t offset, std::string_view name) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const auto line = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
  const std::size_t lineEnd = before.rfind('\n');
  const std::size_t column = lineEnd == std::string_view::npos ? before.size() : before.size() - lineEnd - 1;
  return {std::string(name), line, column + 1};
}

}  // namespace stridegraph
