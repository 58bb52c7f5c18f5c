#pragma once

#include "state/commands.h"

namespace stridegraph {

/// A change by a field: all that happen without letting go of it are one step to undo.
void edit(const Scene& scene, const char* label, Commands& commands);

/// Fields and buttons of what is chosen, within a panel.
void showSelectionFields(const AppState& state, Commands& commands);

}  // namespace stridegraph
