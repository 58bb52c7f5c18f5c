#pragma once

#include <optional>
#include <string_view>

#include "scene/scene.h"

namespace stridegraph {

std::string_view trackRepeatName(TrackRepeat repeat);  ///< "loop", "pingpong", "once"
std::optional<TrackRepeat> trackRepeatFromName(std::string_view name);

}  // namespace stridegraph
