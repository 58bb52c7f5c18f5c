#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include "path/path_planner.h"
#include "path/shortest_path.h"
#include "scene/scene_json.h"

namespace stridegraph {
namespace {

std::string fileText(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// shortest_paths.txt: one line for each map, its name and the length in metres or "none".
TEST(SharedMaps, haveTheKnownShortestPathsAndArePlannedByEveryPlanner) {
  const char* const folder = std::getenv("STRIDEGRAPH_MAPS");
  if (folder == nullptr)
    GTEST_SKIP() << "STRIDEGRAPH_MAPS names no folder with maps and their shortest_paths.txt";
  std::istringstream lines(fileText(std::string(folder) + "/shortest_paths.txt"));
  int maps = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream words(line);
    std::string name;
    std::string length;
    words >> name >> length;
    const Result<Scene> scene = readSceneJson(fileText(std::string(folder) + "/" + name + ".json"), name);
    ASSERT_TRUE(scene) << describe(scene.error());
    const FloorPlan plan(*scene, scene->radiusMetres);
    const Vec2& start = scene->start.position;
    const Vec2& goal = scene->goal.position;
    const auto shortest = shortestPath(plan, start, goal);
    ASSERT_EQ(shortest.has_value(), length != "none") << name;
    for (const PlannerKind planner : {PlannerKind::kPrm, PlannerKind::kRrtConnect}) {
      const PathResult result = planPath(plan, start, goal, planner, 1);
      ASSERT_EQ(result.status == PathStatus::kFound, shortest.has_value()) << name;
      if (!shortest) continue;
      EXPECT_GE(result.lengthMetres, shortest->lengthMetres - 1e-5) << name;
      EXPECT_LE(result.lengthMetres, 1.25 * shortest->lengthMetres) << name << " " << plannerName(planner);
      EXPECT_FALSE(result.usedShortestPath) << name << " " << plannerName(planner);
    }
    if (shortest) {
      EXPECT_NEAR(shortest->lengthMetres, std::stod(length), 0.01) << name;
    }
    ++maps;
  }
  EXPECT_GE(maps, 10);
}

}  // namespace
}  // namespace stridegraph
