#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "bench/document_json.h"
#include "map_folder.h"
#include "program/files.h"

namespace stridegraph::tools {
namespace {

namespace fs = std::filesystem;

class BenchProgram : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    Scene scene;
    scene.start.position = {2, 6};
    scene.goal.position = {10, 6};
    scene.obstacles = {{{6, 6}, {1, 4}}};
    ASSERT_TRUE(writeMapFolder({{bench::kMapsSet, "block", scene, {}}}, in("maps")).has_value());
    fs::remove(in("maps/shortest_paths.txt"));
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string in(const std::string& name) const { return (folder_ / name).string(); }
  std::string content(const std::string& name) const { return readFile(in(name)).value_or(""); }

  /// Whether the program ends well; what it says goes to "log".
  bool run(const std::string& arguments) const {
    const std::string command = std::string(STRIDEGRAPH_PROGRAM) + " bench " + arguments;
    return std::system((command + " > " + in("log") + " 2>&1").c_str()) == 0;
  }

  /// One for each test: they run side by side.
  const fs::path folder_ =
      fs::path(::testing::TempDir()) /
      (std::string("stridegraph_bench_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(BenchProgram, measuresPathsIntoEveryForm) {
  ASSERT_TRUE(run("--maps " + in("maps") + " --seeds 3 --methods exact,prm --json " + in("runs.json") +
                  " --markdown " + in("tables.md") + " --svg " + in("picture.svg")))
      << content("log");
  bench::BenchDocument document;
  ASSERT_TRUE(joinBenchJson(content("runs.json"), "runs.json", document).has_value());
  ASSERT_EQ(document.runs.size(), 4U) << "once exactly, and three seeds";
  for (const bench::BenchRun& run : document.runs) EXPECT_TRUE(isSound(run)) << run.method;
  EXPECT_NE(content("tables.md").find("| block | 1/1 |"), std::string::npos) << content("tables.md");
  EXPECT_NE(content("picture.svg").find("Paths of the disc"), std::string::npos);
}

TEST_F(BenchProgram, tabulatesWhatWasMeasuredBefore) {
  ASSERT_TRUE(
      run("--maps " + in("maps") + " --seeds 1 --methods prm --processor-time --json " + in("runs.json")));
  const std::string tables = content("log").substr(content("log").find("## Paths"));
  ASSERT_TRUE(run("--join " + in("runs.json")));
  EXPECT_EQ(content("log"), tables);
}

TEST_F(BenchProgram, writesRandomRoomsThatItReadsAsMaps) {
  ASSERT_TRUE(run("--random 5 --rooms 2 --first-room 7 --write-scenes " + in("rooms"))) << content("log");
  const auto rooms = readMapFolder(in("rooms"));
  ASSERT_TRUE(rooms.has_value());
  ASSERT_EQ(rooms->size(), 2U);
  EXPECT_EQ(rooms->front().name, "room_0007");
  EXPECT_EQ(rooms->front().scene.name, "random room 7 of 5");
  EXPECT_TRUE(rooms->front().shortestMetres.has_value());
}

TEST_F(BenchProgram, namesWhatItCannotUse) {
  EXPECT_FALSE(run("--maps /nowhere"));
  EXPECT_NE(content("log").find("/nowhere"), std::string::npos);
  EXPECT_FALSE(run("--maps " + in("maps") + " --methods quickest"));
  EXPECT_NE(content("log").find("quickest"), std::string::npos);
  EXPECT_FALSE(run("--join " + in("maps/block.json")));
  EXPECT_NE(content("log").find("block.json: found no list of runs"), std::string::npos) << content("log");
}

}  // namespace
}  // namespace stridegraph::tools
