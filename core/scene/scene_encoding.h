#pragma once

#include <string_view>

#include "base/result.h"

namespace stridegraph {

/// Checks that bytes can be a scene's text: UTF-8, with or without byte-order mark, of at most
/// kMostSceneBytes. Else kSceneSyntax, which names the encoding found (UTF-16, UTF-32) or the first byte that
/// is not UTF-8 and its place. `name` becomes the error's file.
Result<void> checkSceneEncoding(std::string_view bytes, std::string_view name);

}  // namespace stridegraph
