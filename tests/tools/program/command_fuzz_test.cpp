#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>

#include "base/hash.h"
#include "base/utf8.h"
#include "command_folder.h"
#include "math/random.h"
#include "program/output_files.h"

namespace stridegraph::tools {
namespace {

namespace fs = std::filesystem;
using namespace std::string_literals;

/// Runs without STRIDEGRAPH_COMMAND_RUNS in the environment.
constexpr std::size_t kUsualRuns = 60;

std::size_t runCount() {
  const char* const asked = std::getenv("STRIDEGRAPH_COMMAND_RUNS");
  std::size_t count = kUsualRuns;
  if (asked != nullptr) std::from_chars(asked, asked + std::string_view(asked).size(), count);
  return count;
}

/// Values that programs trip over. Paths lie in the test's folder, where every run has its own copies.
const std::vector<std::string>& nastyValues() {
  static const std::vector<std::string> kValues = {"",
                                                   " ",
                                                   "-",
                                                   "--",
                                                   "-5",
                                                   "-0",
                                                   "0",
                                                   "1",
                                                   "2",
                                                   "3",
                                                   "0.5",
                                                   "1e3",
                                                   "nan",
                                                   "NAN",
                                                   "-nan",
                                                   "inf",
                                                   "-inf",
                                                   "1e999",
                                                   "1e-999",
                                                   "12345678901234567890123",
                                                   "18446744073709551615",
                                                   "18446744073709551616",
                                                   "9223372036854775808",
                                                   "4294967296",
                                                   "0x10",
                                                   "010",
                                                   "1,2",
                                                   ",",
                                                   "1,,2",
                                                   "\xff\xfe",
                                                   "gr\xfc\xdf.bvh",
                                                   "\xed\xa0\x80",
                                                   "a\x1b[2Jb",
                                                   "\n",
                                                   "%s%n%d",
                                                   "{}",
                                                   "'; ls",
                                                   std::string(5000, 'x'),
                                                   "/dev/null",
                                                   "/dev/zero",
                                                   "/dev/full",
                                                   "/dev/stdin",
                                                   "/dev/fd/77",
                                                   "/proc/self/mem",
                                                   "/proc/self/maps",
                                                   "/proc",
                                                   ".",
                                                   "folder",
                                                   "folder/",
                                                   "missing",
                                                   "missing/x.bvh",
                                                   "pipe",
                                                   "loop",
                                                   "huge.bvh",
                                                   "empty.json",
                                                   "utf16.json",
                                                   "lib.sgraph",
                                                   "walk.bvh",
                                                   "room.json",
                                                   "closed.json",
                                                   "x.bvh",
                                                   "x.glb",
                                                   "x.sgraph",
                                                   "x.json",
                                                   "link.bvh",
                                                   "auto",
                                                   "prm",
                                                   "guided",
                                                   "thesis",
                                                   "cm",
                                                   "y"};
  return kValues;
}

/// A command with the options that it has; those with a `=` take no value.
struct Command {
  std::string name;
  std::vector<std::string> options;
  std::vector<std::string> usual;  ///< Arguments with which it does something.
};

const std::vector<Command>& commands() {
  static const std::vector<Command> kCommands = {
      {"plan",
       {"--graph", "--scene", "-o", "--seed", "--radius", "--goal-radius", "--moving-ends=", "--planner",
        "--search", "--budget-ms", "--improve", "--until", "--raw-feet=", "--report", "--quiet="},
       {"--graph", "lib.sgraph", "--scene", "room.json", "-o", "x.bvh", "--budget-ms", "300"}},
      {"build",
       {"", "-o", "--append", "--threshold", "--transition-frames", "--neighbours", "--span-ratio",
        "--most-transitions", "--fps", "--units", "--up", "--mirror=", "--license", "--report", "--quiet="},
       {"walk.bvh", "-o", "x.sgraph"}},
      {"info", {"", "--json="}, {"lib.sgraph"}},
      {"bench",
       {"--maps", "--graph", "--seeds", "--methods", "--goal-radius", "--thesis-ms", "--improve-ms",
        "--repeats", "--processor-time=", "--random", "--rooms", "--first-room", "--join", "--json",
        "--markdown", "--svg"},
       {"--rooms", "2", "--write-scenes", "folder"}},
      {"figures", {"--graph", "--scenes", "--folder"}, {"-o", "folder/pictures", "--graph", "missing"}},
      {"paln", {"", "--help="}, {}}};
  return kCommands;
}

/// Arguments of a run: a command as it is usually called with up to four options more, or without some
/// argument.
std::vector<std::string> drawArguments(Random& random) {
  const auto one = [&](const auto& list) { return list[random.below(list.size())]; };
  const Command command = one(commands());
  std::vector<std::string> arguments = {command.name};
  const std::vector<std::string> scenes = {"room.json", "closed.json", "three.json"};
  if (random.below(8) != 0) arguments.insert(arguments.end(), command.usual.begin(), command.usual.end());
  std::replace(arguments.begin(), arguments.end(), std::string("room.json"), one(scenes));
  const std::uint64_t more = random.below(3);
  for (std::uint64_t i = 0; i <= more; ++i) {
    std::string option = one(command.options);
    const bool isFlag = option.ends_with('=');
    if (isFlag) option.pop_back();
    // An option that is there already gets another value.
    const auto known = std::find(arguments.begin() + 1, arguments.end(), option);
    if (!isFlag && !option.empty() && known != arguments.end() && known + 1 != arguments.end()) {
      *(known + 1) = one(nastyValues());
      continue;
    }
    if (!option.empty()) arguments.push_back(option);
    if (!isFlag && random.below(20) != 0) arguments.push_back(one(nastyValues()));
  }
  return arguments;
}

std::string shownCall(const std::vector<std::string>& arguments) {
  std::string call;
  for (const std::string& argument : arguments) call += fmt::format(" '{}'", argument.substr(0, 60));
  return call;
}

class CommandFuzz : public CommandFolder {
 protected:
  void SetUp() override {
    CommandFolder::SetUp();
    fs::create_directories(folder_ / "folder");
    ASSERT_EQ(::mkfifo(in("pipe").c_str(), 0600), 0);
    fs::create_symlink("loop", folder_ / "loop");
    fs::create_symlink("walk.bvh", folder_ / "link.bvh");
    ASSERT_TRUE(writeFile(in("huge.bvh"), "HIERARCHY"));
    fs::resize_file(folder_ / "huge.bvh", std::uintmax_t{1} << 40U);
    ASSERT_TRUE(writeFile(in("empty.json"), std::string_view()));
    ASSERT_TRUE(writeFile(in("utf16.json"), "\xff\xfe{\0}\0"s));
    ASSERT_TRUE(writeFile(in("gr\xfc\xdf.bvh"), content("walk.bvh")));
  }

  /// Hashes of the files that a call is to read. The library that is appended to may be replaced.
  std::map<std::string, std::uint64_t> inputsOf(const std::vector<std::string>& arguments) const {
    const std::set<std::string> readers = {"build", "info", "--graph", "--scene", "--join"};
    std::map<std::string, std::uint64_t> hashes;
    for (std::size_t i = 1; i < arguments.size(); ++i) {
      const std::string& path = arguments[i];
      if (readers.contains(arguments[i - 1]) && isFileThere(in(path)) && path != "huge.bvh")
        hashes[path] = stableHash(content(path));
    }
    return hashes;
  }

  void expectNothingLeftOver() const {
    for (const auto& entry : fs::recursive_directory_iterator(folder_))
      EXPECT_FALSE(entry.path().filename().string().starts_with(".stridegraph")) << entry.path();
  }
};

// Values are such that no call can write outside the folder.
TEST_F(CommandFuzz, endsEveryCallWithAnExitCodeAndSoundText) {
  const std::size_t runs = runCount();
  Random random(2026);
  std::array<std::size_t, 3> ends{};
  for (std::size_t i = 0; i < runs; ++i) {
    SetUp();
    const std::vector<std::string> arguments = drawArguments(random);
    SCOPED_TRACE(fmt::format("run {}:{}", i, shownCall(arguments)));
    const auto inputs = inputsOf(arguments);
    const Ended ended = run(arguments);
    ASSERT_EQ(ended.signal, 0) << ended.err;
    ASSERT_TRUE(ended.exitCode >= 0 && ended.exitCode <= 2) << ended.describe();
    EXPECT_TRUE(isUtf8(ended.out));
    EXPECT_TRUE(isUtf8(ended.err));
    if (ended.exitCode != 0) {
      EXPECT_NE(ended.err + ended.out, "") << "a sentence says why";
    }
    EXPECT_EQ(inputsOf(arguments), inputs);
    expectNothingLeftOver();
    ++ends.at(static_cast<std::size_t>(ended.exitCode));
  }
  fmt::print("{} runs: {} done, {} refused, {} wrong use\n", runs, ends[0], ends[1], ends[2]);
}

}  // namespace
}  // namespace stridegraph::tools
