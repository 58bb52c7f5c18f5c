#include "program/output_files.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "program/descriptor.h"
#include "test_folder.h"

namespace stridegraph::tools {
namespace {

namespace fs = std::filesystem;

class Outputs : public TestFolder {};

TEST_F(Outputs, areThereOnlyOnceAllAreWritten) {
  ASSERT_TRUE(writeFile(in("first"), "of before"));
  {
    OutputFiles files;
    ASSERT_TRUE(files.add(in("first"), "new"));
    ASSERT_TRUE(files.add(in("second"), "new, too"));
    EXPECT_EQ(content("first"), "of before");
    EXPECT_FALSE(fs::exists(in("second")));
    ASSERT_TRUE(files.commit());
  }
  EXPECT_EQ(content("first"), "new");
  EXPECT_EQ(content("second"), "new, too");
  EXPECT_EQ(entryCount(), 2U);
}

TEST_F(Outputs, leaveNothingBehindWhenTheyAreGivenUp) {
  ASSERT_TRUE(writeFile(in("first"), "of before"));
  {
    OutputFiles files;
    ASSERT_TRUE(files.add(in("first"), "new"));
    EXPECT_FALSE(files.add(in("nowhere/second"), "new, too"));
  }
  EXPECT_EQ(content("first"), "of before");
  EXPECT_EQ(entryCount(), 1U);
}

TEST_F(Outputs, keepLinksAndPermissions) {
  ASSERT_TRUE(writeFile(in("file"), "of before"));
  ASSERT_EQ(::chmod(in("file").c_str(), 0640), 0);
  fs::create_symlink("file", folder_ / "link");
  ASSERT_TRUE(writeFile(in("link"), "new"));
  EXPECT_TRUE(fs::is_symlink(in("link")));
  EXPECT_EQ(content("file"), "new");
  struct stat status {};
  ASSERT_EQ(::stat(in("file").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777U, 0640U);
}

TEST_F(Outputs, areMadeWithTheUsualPermissions) {
  const mode_t before = ::umask(027);
  const bool written = writeFile(in("file"), "new").has_value();
  ::umask(before);
  ASSERT_TRUE(written);
  struct stat status {};
  ASSERT_EQ(::stat(in("file").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777U, 0640U);
}

TEST_F(Outputs, followLinksToWhereNothingIsYet) {
  fs::create_symlink("target", folder_ / "link");
  ASSERT_TRUE(writeFile(in("link"), "new"));
  EXPECT_TRUE(fs::is_symlink(in("link")));
  EXPECT_EQ(content("target"), "new");
}

TEST_F(Outputs, sayWhenTheDiskIsFull) {
  const Result<void> written = writeFile("/dev/full", "content");
  ASSERT_FALSE(written);
  EXPECT_EQ(describe(written.error()), "/dev/full: cannot be written: No space left on device");
}

TEST_F(Outputs, goToDevicesAndPipesDirectly) {
  EXPECT_TRUE(writeFile("/dev/null", "content"));
  ASSERT_EQ(::mkfifo(in("pipe").c_str(), 0600), 0);
  EXPECT_EQ(writeFile(in("pipe"), "content").error().message,
            "found a pipe that nobody reads, expected a file");
  const Descriptor reader(::open(in("pipe").c_str(), O_RDONLY | O_NONBLOCK));
  ASSERT_TRUE(writeFile(in("pipe"), "content"));
  std::string read(7, ' ');
  EXPECT_EQ(::read(reader.number(), read.data(), read.size()), 7);
  EXPECT_EQ(read, "content");
}

TEST_F(Outputs, goToDescriptorsByTheirName) {
  const Descriptor file(::open(in("file").c_str(), O_WRONLY | O_CREAT, 0600));
  ASSERT_EQ(::write(file.number(), "first ", 6), 6);
  ASSERT_TRUE(writeFile("/dev/fd/" + std::to_string(file.number()), "second"));
  EXPECT_EQ(content("file"), "first second");
  EXPECT_TRUE(isStandardOutput("/dev/stdout"));
  EXPECT_TRUE(isStandardOutput("/dev/fd/1"));
  EXPECT_FALSE(isStandardOutput(in("file")));
}

TEST_F(Outputs, areNoFoldersAndGoIntoNone) {
  EXPECT_EQ(writeFile(folder_.string(), "x").error().message, "found a folder, expected a file");
  ASSERT_TRUE(writeFile(in("file"), "x"));
  EXPECT_FALSE(writeFile(in("file/inside"), "x"));
  EXPECT_TRUE(makeFolder(in("a/b/c")));
  EXPECT_TRUE(fs::is_directory(in("a/b/c")));
  EXPECT_FALSE(makeFolder(in("file")));
  EXPECT_FALSE(makeFolder(""));
}

TEST_F(Outputs, holdSignalsThatEndTheProgram) {
  const auto isHeld = [] {
    sigset_t held{};
    sigprocmask(SIG_SETMASK, nullptr, &held);
    return sigismember(&held, SIGINT) == 1 && sigismember(&held, SIGTERM) == 1;
  };
  EXPECT_FALSE(isHeld());
  {
    OutputFiles files;
    ASSERT_TRUE(files.add(in("file"), "x"));
    EXPECT_TRUE(isHeld());
    ASSERT_TRUE(files.commit());
  }
  EXPECT_FALSE(isHeld());
}

}  // namespace
}  // namespace stridegraph::tools
