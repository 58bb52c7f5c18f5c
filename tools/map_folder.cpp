#include "map_folder.h"

#include <fmt/format.h>

#include <sstream>

#include "path/shortest_path.h"
#include "program/files.h"
#include "program/output_files.h"
#include "scene/scene_json.h"
#include "scene_folder.h"

namespace stridegraph::tools {

using bench::BenchRoom;

void noteShortest(BenchRoom& room) {
  const FloorPlan plan(room.scene, room.scene.radiusMetres);
  const auto path = shortestPath(plan, room.scene.start.position, room.scene.goal.position);
  if (path) room.shortestMetres = path->lengthMetres;
}

Result<std::vector<BenchRoom>> readMapFolder(const std::string& folder, Warnings* notes) {
  auto files = readSceneFolder(folder, notes);
  if (!files) return fail(std::move(files));
  std::vector<BenchRoom> maps;
  for (SceneFile& file : *files) maps.push_back({bench::kMapsSet, file.name, std::move(file.scene), {}});
  std::vector<bool> known(maps.size(), false);
  std::istringstream lines(readFile(folder + "/shortest_paths.txt").value_or(""));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string name;
    double metres = 0.0;
    words >> name;
    const bool hasWay = static_cast<bool>(words >> metres);
    for (std::size_t m = 0; m < maps.size(); ++m) {
      if (maps[m].name != name) continue;
      known[m] = true;
      if (hasWay) maps[m].shortestMetres = metres;
    }
  }
  for (std::size_t m = 0; m < maps.size(); ++m)
    if (!known[m]) noteShortest(maps[m]);
  return maps;
}

Result<void> writeMapFolder(const std::vector<BenchRoom>& rooms, const std::string& folder) {
  if (auto made = makeFolder(folder); !made) return made;
  OutputFiles files;
  std::string lengths = "# Exact shortest path of the disc, metres\n";
  for (const BenchRoom& room : rooms) {
    auto added = files.add(folder + "/" + room.name + ".json", writeSceneJson(room.scene));
    if (!added) return added;
    lengths += room.shortestMetres ? fmt::format("{} {}\n", room.name, *room.shortestMetres)
                                   : fmt::format("{} none\n", room.name);
  }
  if (auto added = files.add(folder + "/shortest_paths.txt", lengths); !added) return added;
  return files.commit();
}

}  // namespace stridegraph::tools
