#include "map_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "program/output_files.h"
#include "scene/scene_json.h"

namespace stridegraph::tools {
namespace {

namespace fs = std::filesystem;

/// A room of 12 by 12 m, 8 m from start to goal, with a wall across it or not.
Scene room(bool isParted) {
  Scene scene;
  scene.start.position = {2, 6};
  scene.goal.position = {10, 6};
  if (isParted) scene.obstacles = {{{6, 6}, {0.4, 12}}};
  return scene;
}

class MapFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    ASSERT_TRUE(makeFolder().has_value());
  }
  void TearDown() override { fs::remove_all(folder_); }

  Result<void> makeFolder() {
    const std::vector<bench::BenchRoom> maps = {{bench::kMapsSet, "open", room(false), 8.0},
                                                {bench::kMapsSet, "parted", room(true), {}}};
    return writeMapFolder(maps, folder_.string());
  }

  const fs::path folder_ =
      fs::path(::testing::TempDir()) / (std::string("stridegraph_map_folder_") +
                                        ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(MapFolder, comesBackAsItWasWritten) {
  const auto maps = readMapFolder(folder_.string());
  ASSERT_TRUE(maps.has_value()) << describe(maps.error());
  ASSERT_EQ(maps->size(), 2U);
  EXPECT_EQ((*maps)[0].name, "open");
  EXPECT_EQ((*maps)[0].set, bench::kMapsSet);
  EXPECT_EQ((*maps)[0].shortestMetres, 8.0);
  EXPECT_EQ((*maps)[1].name, "parted");
  EXPECT_EQ((*maps)[1].scene.obstacles.size(), 1U);
  EXPECT_FALSE((*maps)[1].shortestMetres.has_value());
}

TEST_F(MapFolder, isBelievedWhatItSaysOfShortestPaths) {
  ASSERT_TRUE(writeFile((folder_ / "shortest_paths.txt").string(), "# lengths\nopen 8.5\n").has_value());
  const auto maps = readMapFolder(folder_.string());
  ASSERT_TRUE(maps.has_value());
  EXPECT_EQ((*maps)[0].shortestMetres, 8.5);
  EXPECT_FALSE((*maps)[1].shortestMetres.has_value()) << "not named, so looked for";
}

TEST_F(MapFolder, findsShortestPathsThatAreNotSaid) {
  fs::remove(folder_ / "shortest_paths.txt");
  const auto maps = readMapFolder(folder_.string());
  ASSERT_TRUE(maps.has_value());
  EXPECT_NEAR((*maps)[0].shortestMetres.value_or(0.0), 8.0, 1e-9);
  EXPECT_FALSE((*maps)[1].shortestMetres.has_value());
}

TEST_F(MapFolder, namesWhatItCannotRead) {
  EXPECT_EQ(readMapFolder("/nowhere").error().message,
            "/nowhere: found No such file or directory, expected a folder of scenes");
  ASSERT_TRUE(writeFile((folder_ / "broken.json").string(), "{").has_value());
  const auto maps = readMapFolder(folder_.string());
  ASSERT_FALSE(maps.has_value());
  EXPECT_NE(describe(maps.error()).find("broken.json"), std::string::npos);
}

}  // namespace
}  // namespace stridegraph::tools
