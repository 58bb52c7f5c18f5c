#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace stridegraph {

/// The name that was most likely meant: the one with the fewest letters inserted, left out, replaced or
/// swapped with their neighbour (optimal string alignment, Damerau 1964), where a name that begins with the
/// other counts as one letter away. Nothing when the nearest differs in more than a third of its letters, at
/// least one, or in all of them. Of equally near names the first.
std::optional<std::string_view> nearestName(std::string_view found, std::span<const std::string_view> names);

}  // namespace stridegraph
