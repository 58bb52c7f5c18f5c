#pragma once

#include <optional>
#include <string_view>

#include "scene/scene.h"

namespace stridegraph {

// What the JSON calls the values of the scene's enumerations.

std::string_view trackRepeatName(TrackRepeat repeat);  ///< "loop", "pingpong", "once"
std::optional<TrackRepeat> trackRepeatFromName(std::string_view name);

std::string_view gaitName(Gait gait);  ///< "walk", "run"
std::optional<Gait> gaitFromName(std::string_view name);

std::string_view areaKindName(AreaKind kind);  ///< "avoid", "prefer"
std::optional<AreaKind> areaKindFromName(std::string_view name);

}  // namespace stridegraph
