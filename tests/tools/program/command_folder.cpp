#include "command_folder.h"

#include <set>

#include "base/utf8.h"
#include "graph/library_builder.h"
#include "graph/sgraph_file.h"
#include "motion/bvh_writer.h"
#include "motion/gait_library.h"
#include "motion/gait_skeleton.h"
#include "program/output_files.h"

namespace stridegraph::tools {
namespace {

const std::string kRoom =
    R"({"name": "Room", "width": 9, "depth": 6, "obstacles": [], "start": {"x": 1.5, "z": 3, "heading_deg": 90},
 "goal": {"x": 7, "z": 3, "heading_deg": 90}})";

/// What the commands work on.
struct Materials {
  std::string library;
  std::string clip;
};

/// A few clips that start, walk and stop: built in less than a second.
Materials makeMaterials() {
  const std::set<std::string> names = {"walk_1.0",   "walk_1.3",  "stand",
                                       "start_left", "stop_left", "stop_right"};
  std::vector<BvhDocument> documents;
  Materials materials;
  for (Clip& clip : defaultGaitClips()) {
    if (!names.contains(clip.name)) continue;
    if (clip.name == "walk_1.3") materials.clip = writeBvh(gaitSkeleton(), gaitBvhLayout(), clip);
    documents.push_back({gaitSkeleton(), gaitBvhLayout(), std::move(clip), {}});
  }
  auto built = buildLibrary(std::move(documents), {.thresholdMetres = 0.04});
  EXPECT_TRUE(built) << describe(built.error());
  if (built) materials.library = textOf(writeSgraph(built->library));
  return materials;
}

const Materials& materials() {
  static const Materials kMaterials = makeMaterials();
  return kMaterials;
}

}  // namespace

void CommandFolder::SetUp() {
  TestFolder::SetUp();
  ASSERT_TRUE(writeFile(in("lib.sgraph"), materials().library));
  ASSERT_TRUE(writeFile(in("walk.bvh"), materials().clip));
  ASSERT_TRUE(writeFile(in("room.json"), kRoom));
  writeRoom("closed.json", R"("obstacles": [])",
            R"("obstacles": [{"x": 4.5, "z": 3, "width": 1, "depth": 8}])");
  writeRoom("three.json", R"("goal")",
            R"("walkers": [{"start": {"x": 1.5, "z": 1, "heading_deg": 90}, "goal": {"x": 7, "z": 1}},
 {"start": {"x": 1.5, "z": 5, "heading_deg": 90}, "goal": {"x": 7, "z": 5}}], "goal")");
}

Ended CommandFolder::run(const std::vector<std::string>& arguments, RunOptions options) const {
  options.folder = folder_.string();
  return runProgramWith(arguments, options);
}

Ended CommandFolder::expectExit(int code, const std::vector<std::string>& arguments,
                                RunOptions options) const {
  Ended ended = run(arguments, std::move(options));
  EXPECT_EQ(ended.exitCode, code) << ended.describe();
  EXPECT_TRUE(isUtf8(ended.out)) << ended.out;
  EXPECT_TRUE(isUtf8(ended.err)) << ended.err;
  return ended;
}

void CommandFolder::writeRoom(const std::string& name, const std::string& from, const std::string& to) const {
  std::string text = kRoom;
  const std::size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  ASSERT_TRUE(writeFile(in(name), text.replace(at, from.size(), to)));
}

}  // namespace stridegraph::tools
