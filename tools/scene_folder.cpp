#include "scene_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "files.h"
#include "scene/scene_json.h"

namespace stridegraph::tools {

Result<std::vector<SceneFile>> readSceneFolder(const std::string& folder) {
  std::error_code failed;
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failed)) {
    if (entry.path().extension() == ".json") paths.push_back(entry.path());
  }
  if (failed)
    return fail(ErrorCode::kFile,
                fmt::format("{}: found {}, expected a folder of scenes", folder, failed.message()));
  std::sort(paths.begin(), paths.end());
  std::vector<SceneFile> scenes;
  for (const std::filesystem::path& path : paths) {
    auto text = readFile(path.string());
    if (!text) return fail(std::move(text));
    auto scene = readSceneJson(*text, path.string());
    if (!scene) return fail(std::move(scene));
    scenes.push_back({path.stem().string(), std::move(*scene)});
  }
  return scenes;
}

Result<void> makeFolder(const std::string& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (!failed) return {};
  return fail(ErrorCode::kFile, fmt::format("{}: cannot be made: {}", folder, failed.message()));
}

}  // namespace stridegraph::tools
