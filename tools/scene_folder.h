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

/// All scenes (*.json) of a folder, by name. kFile for what is no folder; else what readSceneJson refuses.
Result<std::vector<SceneFile>> readSceneFolder(const std::string& folder);

/// Makes the folder, and those that it lies in, where they are not there; kFile where that fails.
Result<void> makeFolder(const std::string& folder);

}  // namespace stridegraph::tools
