#include <filesystem>
#include <nlohmann/json.hpp>

#include "command_folder.h"
#include "program/output_files.h"

namespace stridegraph::tools {
namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

class CommandLine : public CommandFolder {
 protected:
  /// A plan of the room to x.bvh, with more options.
  static Arguments plan(const Arguments& more = {}, const std::string& scene = "room.json") {
    Arguments all = {"plan", "--graph", "lib.sgraph", "--scene", scene, "-o", "x.bvh"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  static bool has(const std::string& text, const std::string& piece) {
    return text.find(piece) != std::string::npos;
  }
  nlohmann::json report(const std::string& name) const { return nlohmann::json::parse(content(name)); }
};

#define EXPECT_HAS(text, piece) EXPECT_TRUE(has(text, piece)) << (text)

TEST_F(CommandLine, saysWhatThereIsWithoutArguments) {
  const Ended ended = expectExit(2, {});
  for (const char* command : {"build", "info", "plan", "gait", "figures", "bench"})
    EXPECT_HAS(ended.out, command);
  EXPECT_EQ(expectExit(0, {"--version"}).out, "0.1.0\n");
}

TEST_F(CommandLine, namesTheNearestOfWhatItDoesNotKnow) {
  EXPECT_HAS(expectExit(2, {"paln"}).err,
             "found paln, expected build, info, plan, gait, figures or bench; did you mean plan?");
  EXPECT_HAS(expectExit(2, {"walk"}).err, "found walk, expected build, info, plan, gait, figures or bench\n");
  EXPECT_HAS(expectExit(2, plan({"--sede", "1"})).err,
             "found --sede, which is no option; did you mean --seed?");
  EXPECT_HAS(expectExit(2, {"plan", "--grpah=x"}).err,
             "found --grpah, which is no option; did you mean --graph?");
  EXPECT_HAS(expectExit(2, {"info", "lib.sgraph", "more"}).err, "found more, expected no further argument");
  EXPECT_HAS(expectExit(2, plan({"--planner", "rrt"})).err,
             "--planner: found rrt, expected prm or rrt-connect; did you mean rrt-connect?");
  EXPECT_HAS(expectExit(2, {"\xff\xfe"}).err, "found \xc3\xbf\xc3\xbe, expected build");
}

TEST_F(CommandLine, givesUnitRangeAndDefaultOfEveryNumber) {
  const std::string plan = expectExit(0, {"plan", "--help"}).out;
  EXPECT_HAS(plan, "--goal-radius X=0.1");
  EXPECT_HAS(plan, "0.01 to 5 metres");
  EXPECT_HAS(plan, "0 to 1000000000 states");
  EXPECT_HAS(plan, "0 to 18446744073709551615");
  const std::string build = expectExit(0, {"build", "--help"}).out;
  EXPECT_HAS(build, "--threshold X=0.05");
  EXPECT_HAS(build, "above 0 to 10 metres");
  EXPECT_HAS(build, "--fps X=30");
  for (const char* command : {"build", "info", "plan", "gait", "figures", "bench"})
    EXPECT_FALSE(expectExit(0, {command, "--help"}).out.empty());
}

TEST_F(CommandLine, refusesNumbersOutOfTheirRange) {
  EXPECT_HAS(expectExit(2, plan({"--improve", "-5"})).err,
             "--improve: found -5, expected a whole number from 0 to 1000000000 states");
  EXPECT_HAS(expectExit(2, plan({"--seed", "12345678901234567890123"})).err,
             "--seed: found 12345678901234567890123, expected a whole number from 0 to 18446744073709551615");
  EXPECT_HAS(expectExit(2, plan({"--radius", "nan"})).err,
             "--radius: found nan, expected a number from 0.05");
  EXPECT_HAS(expectExit(2, plan({"--until", "inf"})).err, "--until: found inf");
  EXPECT_HAS(expectExit(2, {"build", "walk.bvh", "-o", "x.sgraph", "--threshold", "0"}).err,
             "--threshold: found 0, expected a number above 0 to 10 metres");
  EXPECT_HAS(expectExit(2, {"build", "walk.bvh", "-o", "x.sgraph", "--units", "-1"}).err,
             "--units: found -1, expected auto, m, cm, in or metres per unit");
  EXPECT_HAS(expectExit(2, {"bench", "--growth-walkers", "1,102"}).err,
             "found 102, expected a whole number from 1");
  EXPECT_FALSE(fs::exists(in("x.bvh")));
}

TEST_F(CommandLine, saysWhatBenchNeeds) {
  EXPECT_HAS(expectExit(2, {"bench"}).err, "found nothing to measure, expected one of: --maps FOLDER");
  EXPECT_HAS(expectExit(2, {"bench", "--random", "1"}).err, "found nothing to measure");
}

TEST_F(CommandLine, keepsTextThatIsNotUtf8OutOfAllOutputs) {
  const std::string clip = in("gr\xfc\xdf.bvh");
  fs::copy_file(in("walk.bvh"), clip);
  const Ended built = expectExit(0, {"build", "walk.bvh", clip, "-o", "b\xfc.sgraph", "--threshold", "0.08",
                                     "--license", "\xa9 M\xfcller", "--report", "r.json"});
  EXPECT_HAS(built.err, "note: --license: found text that is not UTF-8, read it as Windows-1252");
  EXPECT_HAS(content("r.json"), "gr\xc3\xbc\xc3\x9f");
  const Ended info = expectExit(0, {"info", "b\xfc.sgraph", "--json"});
  EXPECT_EQ(nlohmann::json::parse(info.out)["license"], "\xc2\xa9 M\xc3\xbcller");
  expectExit(0, {"info", "b\xfc.sgraph"});
}

TEST_F(CommandLine, readsNeitherFoldersNorDevicesNorWhatHasNoEnd) {
  for (const char* path :
       {"/proc/self/mem", "/dev/zero", "/dev/null", ".", "", "missing.json", "room.json/x"}) {
    EXPECT_EQ(expectExit(2, plan({}, path)).out, "");
    expectExit(2, {"info", path});
    expectExit(2, {"build", path, "-o", "x.sgraph"});
  }
  EXPECT_HAS(expectExit(2, plan({}, "/dev/zero")).err, "/dev/zero: found a device, expected a file");
}

TEST_F(CommandLine, neverOverwritesWhatItReads) {
  const auto expectRefused = [&](const Arguments& arguments, const std::string& why) {
    const std::string library = content("lib.sgraph");
    const std::string clip = content("walk.bvh");
    const std::string room = content("room.json");
    EXPECT_HAS(expectExit(2, arguments).err, why);
    EXPECT_TRUE(content("lib.sgraph") == library && content("walk.bvh") == clip &&
                content("room.json") == room);
  };
  fs::create_symlink("walk.bvh", folder_ / "link.bvh");
  fs::create_hard_link(folder_ / "room.json", folder_ / "hard.bvh");
  expectRefused({"build", "walk.bvh", "-o", "./walk.bvh"}, "-o would overwrite a clip");
  expectRefused({"build", "link.bvh", "-o", "x.sgraph", "--report", "walk.bvh"},
                "--report would overwrite a clip");
  expectRefused({"build", "walk.bvh", "-o", "x.sgraph", "--append", "lib.sgraph", "--report", "lib.sgraph"},
                "--report would overwrite --append");
  expectRefused({"plan", "--graph", "lib.sgraph", "--scene", "room.json", "-o", "hard.bvh"},
                "-o would overwrite --scene");
  expectRefused(plan({"--report", "lib.sgraph"}), "--report would overwrite --graph");
  expectRefused(plan({"--report", "x.bvh"}), "--report would overwrite -o");
  expectRefused({"bench", "--join", "room.json", "--json", "room.json"}, "--json would overwrite --join");
}

TEST_F(CommandLine, neverOverwritesAScenesOwnFileWithAFurtherWalk) {
  fs::create_symlink("three.json", folder_ / "x_2.bvh");
  const std::string before = content("three.json");
  EXPECT_HAS(expectExit(2, plan({}, "three.json")).err, "-o of walker 2 would overwrite --scene");
  EXPECT_EQ(content("three.json"), before);
}

TEST_F(CommandLine, mayReplaceTheLibraryThatItAppendsTo) {
  const std::string before = content("lib.sgraph");
  fs::copy_file(in("walk.bvh"), in("again.bvh"));
  expectExit(0, {"build", "again.bvh", "-o", "lib.sgraph", "--append", "lib.sgraph"});
  EXPECT_FALSE(content("lib.sgraph") == before);
  EXPECT_HAS(expectExit(0, {"info", "lib.sgraph"}).out, "again");
}

TEST_F(CommandLine, takesAClipThatIsGivenTwiceOnce) {
  fs::create_symlink("walk.bvh", folder_ / "link.bvh");
  const Ended built =
      expectExit(0, {"build", "walk.bvh", "./walk.bvh", "link.bvh", "-o", "x.sgraph", "--threshold", "0.08"});
  EXPECT_HAS(built.err, "note: ./walk.bvh: is the same file as walk.bvh, which is taken once");
  EXPECT_HAS(built.err, "note: link.bvh: is the same file as walk.bvh, which is taken once");
  EXPECT_HAS(built.out, "1 of 1 clips");
}

TEST_F(CommandLine, saysThatAWalkOfBeforeIsStillThere) {
  expectExit(0, plan());
  const std::string before = content("x.bvh");
  const Ended refused = expectExit(1, plan({"--report", "r.json"}, "closed.json"));
  EXPECT_HAS(refused.err, "note: x.bvh: is still the file of before, not a walk of this plan");
  EXPECT_TRUE(content("x.bvh") == before);
  EXPECT_EQ(report("r.json")["notes"][0]["file"], "x.bvh");
  EXPECT_HAS(expectExit(2, plan({}, "missing.json")).err, "x.bvh: is still the file of before");
  EXPECT_HAS(expectExit(2, plan({"--report", "r.json"}, "missing.json")).err,
             "r.json: is still the file of before");
}

TEST_F(CommandLine, saysThatWalksOfFurtherWalkersAreOfBefore) {
  expectExit(0, plan({}, "three.json"));
  const Ended one = expectExit(0, plan());
  EXPECT_HAS(one.err, "note: x_2.bvh: is still the file of before");
  EXPECT_HAS(one.err, "note: x_3.bvh: is still the file of before");
}

TEST_F(CommandLine, keepsTheFileOfBeforeWhenTheDiskIsFull) {
  expectExit(0, plan());
  const std::string before = content("x.bvh");
  const std::size_t entries = entryCount();
  RunOptions full;
  full.mostFileBytes = 1000;
  const Ended ended = expectExit(2, plan({"--seed", "2"}), full);
  EXPECT_HAS(ended.err, "x.bvh: cannot be written: File too large");
  EXPECT_TRUE(content("x.bvh") == before);
  EXPECT_EQ(entryCount(), entries);
}

TEST_F(CommandLine, writesWalkAndReportTogetherOrNeither) {
  const Ended ended = expectExit(2, plan({"--report", "/dev/full"}));
  EXPECT_HAS(ended.err, "/dev/full: cannot be written: No space left on device");
  EXPECT_FALSE(fs::exists(in("x.bvh")));
}

TEST_F(CommandLine, writesReportsToStandardOutputAlone) {
  const Ended ended = expectExit(0, plan({"--report", "/dev/stdout"}));
  EXPECT_EQ(nlohmann::json::parse(ended.out)["status"], "arrived");
  EXPECT_HAS(ended.err, "x.bvh: ");
  expectExit(0, plan({"--report", "/dev/null"}));
}

TEST_F(CommandLine, saysWhenItCannotPrint) {
  RunOptions full;
  full.outPath = "/dev/full";
  EXPECT_HAS(expectExit(2, {"info", "lib.sgraph"}, full).err,
             "standard output cannot be written: No space left on device");
  EXPECT_EQ(expectExit(2, {"--help"}, full).exitCode, 2);
  RunOptions closed;
  closed.closesOutput = true;
  expectExit(0, plan(), closed);
  EXPECT_EQ(content("x.bvh").substr(0, 9), "HIERARCHY");
}

TEST_F(CommandLine, notesWhatASceneHasThatIsNotKnown) {
  fs::copy_file(std::string(STRIDEGRAPH_CASES) + "/misspelt_members.json", in("misspelt.json"));
  const Ended ended = expectExit(0, plan({"--report", "r.json"}, "misspelt.json"));
  EXPECT_HAS(ended.err,
             "note: misspelt.json:1:83: found start.heading, which has no effect; did you mean heading_deg?");
  EXPECT_HAS(ended.err,
             "note: misspelt.json:1:125: found constraint, which has no effect; did you mean constraints?");
  const nlohmann::json notes = report("r.json")["notes"];
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_EQ(notes[0]["topic"], "scene");
  EXPECT_EQ(notes[0]["line"], 1);
  EXPECT_EQ(notes[0]["column"], 83);
}

TEST_F(CommandLine, keepsSceneNamesInAnyScript) {
  fs::copy_file(std::string(STRIDEGRAPH_CASES) + "/names_not_latin.json", in("names.json"));
  run(plan({"--report", "r.json"}, "names.json"));
  EXPECT_EQ(report("r.json")["scene"], nlohmann::json::parse(content("names.json"))["name"]);
}

TEST_F(CommandLine, namesOptionsWithoutEffect) {
  EXPECT_HAS(expectExit(0, plan({"--until", "1.1"})).err, "note: --until: has no effect without --improve");
  EXPECT_HAS(expectExit(0, plan({"--planner", "prm"})).err, "note: --planner: hardly changes the walk");
  EXPECT_HAS(run(plan({"--search", "thesis", "--improve", "10", "--budget-ms", "100"})).err,
             "note: --improve: has no effect, since only --search guided finds better walks");
  EXPECT_HAS(
      expectExit(2, {"build", "walk.bvh", "-o", "x.sgraph", "--append", "lib.sgraph", "--threshold", "1"})
          .err,
      "--append excludes --threshold");
  EXPECT_HAS(expectExit(0, {"bench", "--growth-frames", "1", "--rooms", "3"}).err,
             "note: --rooms: has no effect without --random");
}

TEST_F(CommandLine, saysNothingButErrorsWhenQuiet) {
  const Ended ended = expectExit(0, plan({"--until", "1.1", "--quiet"}));
  EXPECT_EQ(ended.out + ended.err, "");
  EXPECT_HAS(expectExit(1, plan({"-q"}, "closed.json")).err, "no_path");
}

TEST_F(CommandLine, roundsFiguresForPeople) {
  const std::string info = expectExit(0, {"info", "lib.sgraph"}).out;
  EXPECT_HAS(info, "threshold_m        0.04\n");
  for (std::size_t at = info.find('.'); at != std::string::npos; at = info.find('.', at + 1)) {
    std::size_t digits = 0;
    while (std::isdigit(static_cast<unsigned char>(info[at + 1 + digits])) != 0) ++digits;
    EXPECT_LE(digits, 4U) << info.substr(at > 20 ? at - 20 : 0, 40);
  }
}

TEST_F(CommandLine, improvesAsThePlannerDoesAtOnce) {
  expectExit(0, plan({"--improve", "50000", "--report", "r.json"}));
  const nlohmann::json report = this->report("r.json");
  EXPECT_GT(report["expansions"].get<std::uint64_t>(), 1000U);
  expectExit(0, plan({"--improve", "50000", "--budget-ms", "60000", "--report", "s.json"}));
  EXPECT_EQ(this->report("s.json")["edges"], report["edges"]);
}

}  // namespace
}  // namespace stridegraph::tools
