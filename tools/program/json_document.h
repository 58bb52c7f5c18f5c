#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "base/error.h"

namespace stridegraph::tools {

/// Members in the order in which they are set.
using Json = nlohmann::ordered_json;

/// The text of a JSON file. Texts that are not UTF-8 do not make it fail: their wrong bytes become U+FFFD.
inline std::string documentText(const Json& json) {
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// Notes as reports hold them: [{"topic": "scene", "message": "...", "file": "room.json", "line": 1,
/// "column": 7}]; parts of the place that are not known are left out.
Json notesJson(const Warnings& notes);

}  // namespace stridegraph::tools
