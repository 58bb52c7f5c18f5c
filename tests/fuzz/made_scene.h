#pragma once

#include "input.h"
#include "scene/scene.h"

namespace stridegraph::fuzz {

/// A room of up to 16 m, rarely 64 m, with what scenes may hold: blocks, moving blocks, walkers, constraints.
/// Now and then a number is none that a scene may have.
Scene madeScene(Input& input);

/// One more block somewhere in a room.
Rectangle madeBlock(Input& input, const Scene& room);

}  // namespace stridegraph::fuzz
