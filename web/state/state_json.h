#pragma once

#include <string>
#include <vector>

#include "state/app_state.h"

namespace stridegraph {

/// What the page's inspection object says (docs/page.md): a JSON object for tests and the curious.
std::string toJson(const AppState& state);

/// Which texts the app can show, as a JSON object: `waiting` while a frame is still to draw some, `missing`
/// those that nobody can draw.
std::string letteringJson(bool isWaiting, const std::vector<std::string>& missing);

}  // namespace stridegraph
