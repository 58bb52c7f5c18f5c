#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "scene/scene.h"

namespace stridegraph {

/// Reads a scene (DESIGN, section 4). Unknown members are kept for writeSceneJson; a known one that is
/// missing, of the wrong type or out of range is kSceneValue, and names the member, what was found and what
/// was expected.
Result<Scene> readSceneJson(std::string_view text, std::string_view name = "scene");

/// The scene as JSON text; reading it back gives the same scene, bit for bit.
std::string writeSceneJson(const Scene& scene);

/// What is wrong with a scene's values, as readSceneJson says it; nothing when the scene is usable.
Result<void> checkScene(const Scene& scene);

}  // namespace stridegraph
