#pragma once

#include <string>

#include "state/app_state.h"

namespace stridegraph {

/// What the page's inspection object says (docs/page.md): a JSON object for tests and the curious.
std::string toJson(const AppState& state);

}  // namespace stridegraph
