#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "scene/scene.h"

namespace stridegraph::tools {

/// A scene and the name of its file, without ".json".
struct SceneFile {
  std::string name;
  Scene scene;
};

/// All scenes (*.json) of a folder, by name; what is odd about them goes to `notes` where it is not null.
/// kFile for what is no folder; else what readSceneJson refuses.
Result<std::vector<SceneFile>> readSceneFolder(const std::string& folder, Warnings* notes = nullptr);

}  // namespace stridegraph::tools
