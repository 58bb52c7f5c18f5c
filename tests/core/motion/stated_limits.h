#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>

namespace stridegraph::testing {

/// The figure in a table's row "| name | 1,000 | ..." of a document; fails and is -1 without such a row.
inline double statedLimit(std::string_view document, std::string_view name) {
  const std::string row = "\n| " + std::string(name) + " |";
  const std::size_t at = document.find(row);
  EXPECT_NE(at, std::string_view::npos) << "no limit of " << name;
  if (at == std::string_view::npos) return -1.0;
  const std::size_t begin = at + row.size();
  std::string figure(document.substr(begin, document.find('|', begin) - begin));
  figure.erase(std::remove(figure.begin(), figure.end(), ','), figure.end());
  return std::strtod(figure.c_str(), nullptr);
}

}  // namespace stridegraph::testing
