#include "base/nearest_name.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace stridegraph {
namespace {

/// Longer names are not compared: no name of this project has as many letters.
constexpr std::size_t kLongestName = 64;

/// Rows i - 2, i - 1 and i of the table of distances between beginnings of both names.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::array<std::vector<std::size_t>, 3> rows;
  for (std::vector<std::size_t>& row : rows) row.resize(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) rows[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::vector<std::size_t>& row = rows.at(i % 3);
    const std::vector<std::size_t>& above = rows.at((i + 2) % 3);
    const std::vector<std::size_t>& twoAbove = rows.at((i + 1) % 3);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], twoAbove[j - 2] + 1);
    }
  }
  return rows.at(a.size() % 3)[b.size()];
}

std::size_t distanceOf(std::string_view found, std::string_view name) {
  const std::size_t distance = editDistance(found, name);
  // Units and endings are what people leave out: "heading" for "heading_deg".
  constexpr std::size_t kLeastBeginning = 3;
  const bool isBeginning = std::min(found.size(), name.size()) >= kLeastBeginning &&
                           (found.starts_with(name) || name.starts_with(found));
  return isBeginning ? std::min<std::size_t>(distance, 1) : distance;
}

}  // namespace

std::optional<std::string_view> nearestName(std::string_view found, std::span<const std::string_view> names) {
  if (found.empty() || found.size() > kLongestName) return std::nullopt;
  std::optional<std::string_view> nearest;
  std::size_t least = 0;
  for (const std::string_view name : names) {
    const std::size_t distance = distanceOf(found, name);
    if (nearest && distance >= least) continue;
    nearest = name;
    least = distance;
  }
  if (!nearest || least >= std::min(found.size(), nearest->size())) return std::nullopt;
  if (least > std::max<std::size_t>(1, nearest->size() / 3)) return std::nullopt;
  return nearest;
}

}  // namespace stridegraph
