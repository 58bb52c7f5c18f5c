#include "program/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <filesystem>

#include "base/utf8.h"
#include "program/descriptor.h"
#include "program/output_files.h"
#include "scene/scene_limits.h"
#include "test_folder.h"

namespace stridegraph::tools {
namespace {

class Files : public TestFolder {
 protected:
  std::string refusal(const std::string& path, std::uint64_t most = kMostReportBytes) const {
    const Result<std::string> content = readFile(path, most);
    if (content) return "read";
    EXPECT_EQ(content.error().code, ErrorCode::kFile);
    return content.error().message;
  }
};

TEST_F(Files, areReadWhole) {
  std::string bytes;
  for (int i = 0; i < 300'000; ++i) bytes += static_cast<char>(i % 251);
  ASSERT_TRUE(writeFile(in("bytes"), bytes));
  EXPECT_EQ(content("bytes"), bytes);
  ASSERT_TRUE(writeFile(in("empty"), std::string_view()));
  EXPECT_EQ(content("empty"), "");
}

TEST_F(Files, areRefusedWithWhatWasFoundInstead) {
  EXPECT_EQ(refusal(""), "found an empty name, expected that of a file");
  EXPECT_EQ(refusal(in("missing")), "cannot be opened: No such file or directory");
  EXPECT_EQ(refusal(folder_.string()), "found a folder, expected a file");
  EXPECT_EQ(refusal("/dev/zero"), "found a device, expected a file");
  EXPECT_EQ(refusal("/dev/null"), "found a device, expected a file");
  EXPECT_EQ(refusal(std::string(10'000, 'x')), "cannot be opened: File name too long");
  std::filesystem::create_symlink("loop", folder_ / "loop");
  EXPECT_EQ(refusal(in("loop")), "cannot be opened: Too many levels of symbolic links");
}

TEST_F(Files, neverMakeTheProgramWaitForAPipeThatNobodyWritesTo) {
  ASSERT_EQ(::mkfifo(in("pipe").c_str(), 0600), 0);
  EXPECT_EQ(refusal(in("pipe")), "found a pipe that nothing writes to, expected a file");
}

TEST_F(Files, mayBePipesWithSomethingInThem) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const Descriptor reader(ends[0]);
  Descriptor writer(ends[1]);
  ASSERT_EQ(::write(writer.number(), "content", 7), 7);
  ASSERT_TRUE(writer.close());
  const Result<std::string> content = readFile("/dev/fd/" + std::to_string(reader.number()));
  ASSERT_TRUE(content) << describe(content.error());
  EXPECT_EQ(*content, "content");
}

TEST_F(Files, fromPipesHaveALimitToo) {
  ASSERT_EQ(::mkfifo(in("pipe").c_str(), 0600), 0);
  const Descriptor both(::open(in("pipe").c_str(), O_RDWR | O_NONBLOCK));
  ASSERT_EQ(::write(both.number(), "content", 7), 7);
  EXPECT_EQ(refusal(in("pipe"), 3), "found more, expected at most 3 bytes");
}

TEST_F(Files, areRefusedUnreadWhereTheyAreTooLarge) {
  ASSERT_TRUE(writeFile(in("large"), "x"));
  std::filesystem::resize_file(folder_ / "large", std::uintmax_t{1} << 40U);
  EXPECT_EQ(refusal(in("large")), "found 1 TiB, expected at most 1 GiB");
  EXPECT_EQ(refusal(in("large"), kMostSceneBytes), "found 1 TiB, expected at most 16 MiB");
}

TEST_F(Files, thatFailWhenTheyAreReadSaySo) {
  EXPECT_EQ(refusal("/proc/self/mem"), "cannot be read: Input/output error");
}

TEST_F(Files, haveNamesThatAreShownAsUtf8) {
  const Result<std::string> content = readFile(in("caf\xe9"));
  ASSERT_FALSE(content);
  EXPECT_TRUE(isUtf8(content.error().place.file));
  EXPECT_NE(content.error().place.file.find("caf\xc3\xa9"), std::string::npos);
}

}  // namespace
}  // namespace stridegraph::tools
