#pragma once

#include <string>

#include "state/app_state.h"

namespace stridegraph {

/// Whether the scene has such an item; kNothing is none.
bool isThere(const Scene& scene, const Item& item);

/// The start or goal that an item is; null for all others and for what is not there.
Placement* placementOf(Scene& scene, const Item& item);
const Placement* placementOf(const Scene& scene, const Item& item);

/// The block or area that an item is; null for all others and for what is not there.
Rectangle* rectangleOf(Scene& scene, const Item& item);
const Rectangle* rectangleOf(const Scene& scene, const Item& item);

/// Whether the item may be deleted: all but the first walker's start and goal.
bool isRemovable(const Scene& scene, const Item& item);

/// The scene without the item; with start or goal of a further walker the whole walker goes.
Scene without(const Scene& scene, const Item& item);

/// What people call the item: "block", "moving block", "area", "walker", "start", "goal".
std::string kindName(const Item& item);

}  // namespace stridegraph
