#include "program/name_list.h"

#include <fmt/format.h>

#include "base/nearest_name.h"

namespace stridegraph::tools {

std::string listOf(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + names[i];
  return text;
}

std::string suggestionFor(const std::string& found, const std::vector<std::string>& names) {
  const std::vector<std::string_view> views(names.begin(), names.end());
  const auto nearest = nearestName(found, views);
  return nearest ? fmt::format("; did you mean {}?", *nearest) : "";
}

}  // namespace stridegraph::tools
