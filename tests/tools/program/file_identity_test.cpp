#include "program/file_identity.h"

#include <unistd.h>

#include <filesystem>

#include "program/output_files.h"
#include "test_folder.h"

namespace stridegraph::tools {
namespace {

namespace fs = std::filesystem;

class Identity : public TestFolder {
 protected:
  void SetUp() override {
    TestFolder::SetUp();
    fs::create_directories(folder_ / "sub");
    ASSERT_TRUE(writeFile(in("a"), "a"));
    ASSERT_TRUE(writeFile(in("b"), "b"));
  }
  bool same(const std::string& first, const std::string& second) const {
    return FileIdentity(in(first)).isSameAs(FileIdentity(in(second)));
  }
  std::string refusal(const std::vector<NamedPath>& inputs, const std::vector<NamedPath>& outputs) const {
    const Result<void> checked = checkOutputs(inputs, outputs);
    return checked ? "" : checked.error().message;
  }
};

TEST_F(Identity, isThatOfTheFileHoweverItIsWritten) {
  fs::create_symlink("a", folder_ / "link");
  fs::create_hard_link(folder_ / "a", folder_ / "hard");
  fs::create_directory_symlink("sub", folder_ / "folder");
  EXPECT_TRUE(same("a", "a"));
  EXPECT_TRUE(same("a", "sub/../a"));
  EXPECT_TRUE(same("a", "./a"));
  EXPECT_TRUE(same("a", "link"));
  EXPECT_TRUE(same("hard", "link"));
  EXPECT_FALSE(same("a", "b"));
  EXPECT_TRUE(same("sub", "folder"));
}

TEST_F(Identity, isKnownOfFilesThatAreNotThereYet) {
  fs::create_directory_symlink("sub", folder_ / "folder");
  fs::create_symlink("sub/new", folder_ / "link");
  EXPECT_TRUE(same("sub/new", "folder/new"));
  EXPECT_TRUE(same("sub/new", "link"));
  EXPECT_FALSE(same("sub/new", "new"));
  EXPECT_FALSE(same("sub/new", "sub/other"));
  EXPECT_FALSE(same("nowhere/new", "nowhere/new")) << "nothing is known of it";
}

TEST_F(Identity, ofPipesAndDevicesIsNone) {
  EXPECT_FALSE(FileIdentity("/dev/null").isSameAs(FileIdentity("/dev/null")));
}

TEST_F(Identity, leadsThroughLinks) {
  fs::create_symlink("sub/new", folder_ / "link");
  fs::create_symlink(in("link"), folder_ / "again");
  EXPECT_EQ(resolveLinks(in("again")), in("sub/new"));
  EXPECT_EQ(resolveLinks(in("a")), in("a"));
  fs::create_symlink("loop", folder_ / "loop");
  EXPECT_FALSE(resolveLinks(in("loop")).empty()) << "ends";
}

TEST_F(Identity, letsNoOutputOverwriteAnInput) {
  fs::create_symlink("a", folder_ / "link");
  EXPECT_EQ(refusal({{"--scene", in("a")}}, {{"-o", in("b")}}), "");
  EXPECT_EQ(refusal({{"--scene", in("a")}}, {{"-o", in("link")}}),
            "-o would overwrite --scene, expected another file");
  EXPECT_EQ(refusal({}, {{"-o", in("new")}, {"--report", in("sub/../new")}}),
            "--report would overwrite -o, expected another file");
  EXPECT_EQ(refusal({}, {{"-o", "/dev/null"}, {"--report", "/dev/null"}}), "");
}

TEST_F(Identity, letsNoOutputGoWhereNoneCanBe) {
  EXPECT_EQ(refusal({}, {{"-o", ""}}), "-o: found an empty name, expected that of a file");
  EXPECT_EQ(refusal({}, {{"-o", in("sub")}}), "-o: found a folder, expected a file");
  EXPECT_NE(refusal({}, {{"-o", in("nowhere/new")}}).find("nowhere cannot be opened: No such file"),
            std::string::npos);
  EXPECT_NE(refusal({}, {{"-o", in("a/new")}}), "");
}

}  // namespace
}  // namespace stridegraph::tools
