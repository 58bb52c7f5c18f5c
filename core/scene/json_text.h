#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "base/result.h"

namespace stridegraph {

/// Members in the order of the text.
using Json = nlohmann::ordered_json;

/// Parses JSON. kSceneSyntax with line and column when the text is none, or when it nests deeper than
/// kMostJsonLevels or an object has more than kMostJsonMembers: to write such a value back would take a deep
/// stack, to look up its members long. Of members of one name the last counts.
Result<Json> parseJson(std::string_view text, std::string_view name);

/// A value as messages quote it: short values as they stand, long ones by their kind.
std::string quoted(const Json& value);

}  // namespace stridegraph
