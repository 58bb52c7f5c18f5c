#include "scene_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "program/files.h"
#include "program/shown_text.h"
#include "scene/scene_json.h"
#include "scene/scene_limits.h"

namespace stridegraph::tools {

Result<std::vector<SceneFile>> readSceneFolder(const std::string& folder, Warnings* notes) {
  std::error_code wrong;
  std::vector<std::filesystem::path> paths;
  for (std::filesystem::directory_iterator entry(folder, wrong), end; !wrong && entry != end;
       entry.increment(wrong)) {
    if (entry->path().extension() == ".json") paths.push_back(entry->path());
  }
  if (wrong)
    return fail(ErrorCode::kFile,
                fmt::format("{}: found {}, expected a folder of scenes", shownText(folder), wrong.message()));
  std::sort(paths.begin(), paths.end());
  std::vector<SceneFile> scenes;
  for (const std::filesystem::path& path : paths) {
    auto text = readFile(path.string(), kMostSceneBytes);
    if (!text) return fail(std::move(text));
    auto scene = readSceneJson(*text, shownText(path.string()), notes);
    if (!scene) return fail(std::move(scene));
    scenes.push_back({shownText(path.stem().string()), std::move(*scene)});
  }
  return scenes;
}

}  // namespace stridegraph::tools
