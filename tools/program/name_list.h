#pragma once

#include <string>
#include <vector>

namespace stridegraph::tools {

/// "build, info or plan".
std::string listOf(const std::vector<std::string>& names);

/// "; did you mean plan?" with the nearest of the names (nearestName); empty where none is near.
std::string suggestionFor(const std::string& found, const std::vector<std::string>& names);

}  // namespace stridegraph::tools
