#pragma once

#include <string_view>

#include "base/error.h"

namespace stridegraph {

/// What is odd about the members of a scene's JSON: names that this version does not know, with the nearest
/// one that it does, and names that an object has more than once. One warning with topic kScene for each kind
/// of object and name, at the first place; the message counts the others. Names past the first
/// kMostSceneNotes are counted together. The text is valid JSON; `name` becomes the warnings' file.
Warnings sceneNotes(std::string_view text, std::string_view name);

}  // namespace stridegraph
