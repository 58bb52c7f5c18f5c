#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "bench/document_json.h"
#include "bench/growth.h"
#include "bench/picture.h"
#include "bench/random_room.h"
#include "bench/tables.h"
#include "bench_arguments.h"
#include "commands.h"
#include "library_file.h"
#include "map_folder.h"
#include "notes.h"
#include "program/files.h"
#include "program/output_files.h"
#include "program/progress.h"
#include "program/shown_text.h"
#include "wall_clock.h"

namespace stridegraph::tools {
namespace {

using bench::BenchDocument;
using bench::BenchRoom;

struct BenchLibrary {
  std::string name;
  std::unique_ptr<const WalkPlanner> planner;
};

Result<BenchLibrary> openLibrary(const std::string& path) {
  auto library = readLibraryFile(path);
  if (!library) return fail(std::move(library));
  return BenchLibrary{
      shownText(std::filesystem::path(path).stem().string()),
      std::make_unique<WalkPlanner>(std::make_shared<const MotionLibrary>(std::move(*library)))};
}

/// Measures everything that is asked for, one task after the other.
class Bench {
 public:
  explicit Bench(const BenchArguments& arguments) : arguments_(arguments) {}

  Result<BenchDocument> measure();

 private:
  Result<void> readRooms();
  void makeRandomRooms();
  Result<void> join();
  void measurePaths();
  void measureWalks(const BenchLibrary& library);
  void measureRandomRooms(const BenchLibrary& library);
  void measureGrowthOfFrames();
  void measureGrowthOfRooms(const BenchLibrary& library);
  std::size_t taskCount() const;
  void finishTask();

  const BenchArguments& arguments_;
  std::vector<BenchRoom> maps_;
  std::vector<BenchRoom> rooms_;
  BenchDocument document_;
  std::optional<Progress> progress_;
  std::size_t tasks_ = 0;
  std::size_t tasksDone_ = 0;
};

/// Maps, random rooms and sizes, each as often as it is measured; of random rooms also that they are made.
std::size_t Bench::taskCount() const {
  const std::size_t graphs = arguments_.graphPaths.size();
  const std::size_t rooms = arguments_.randomSeed ? static_cast<std::size_t>(arguments_.rooms) : 0;
  const std::size_t grown = graphs > 0 ? arguments_.rectangles.size() + arguments_.walkers.size() : 0;
  return (1 + graphs) * (maps_.size() + rooms) + grown + arguments_.frames.size();
}

void Bench::finishTask() {
  ++tasksDone_;
  progress_->at(static_cast<double>(tasksDone_) / static_cast<double>(std::max<std::size_t>(tasks_, 1)));
}

Result<void> Bench::readRooms() {
  if (arguments_.mapsFolder.empty()) return {};
  Warnings notes;
  auto maps = readMapFolder(arguments_.mapsFolder, &notes);
  if (!maps) return fail(std::move(maps));
  printNotes(notes, arguments_.isQuiet);
  maps_ = std::move(*maps);
  return {};
}

void Bench::makeRandomRooms() {
  if (!arguments_.randomSeed) return;
  for (std::uint64_t i = 0; i < arguments_.rooms; ++i) {
    const std::uint64_t number = arguments_.firstRoom + i;
    rooms_.push_back({bench::kRandomSet,
                      fmt::format("room_{:04}", number),
                      bench::randomRoom(*arguments_.randomSeed, number),
                      {}});
    noteShortest(rooms_.back());
    finishTask();
  }
}

void Bench::measurePaths() {
  for (const BenchRoom& map : maps_) {
    for (const bench::PathMethod& method : bench::pathMethods()) {
      if (!arguments_.asksFor(method.name)) continue;
      const std::uint64_t seeds = method.seeded ? arguments_.seeds : 1;
      for (std::uint64_t seed = 1; seed <= seeds; ++seed)
        document_.runs.push_back(bench::measurePath(method, map, seed, arguments_.measure));
    }
    finishTask();
  }
}

void Bench::measureWalks(const BenchLibrary& library) {
  const auto measureOne = [&](const BenchRoom& room, const bench::WalkMethod& method, std::uint64_t seed) {
    bench::BenchRun run = bench::measureWalk(*library.planner, room, method, seed, arguments_.measure);
    run.library = library.name;
    return run;
  };
  for (const BenchRoom& map : maps_) {
    for (const bench::WalkMethod& method : bench::walkMethods()) {
      if (!arguments_.asksFor(method.name)) continue;
      measureOne(map, method, 0);  // Caches and memory are warm from here on.
      for (std::uint64_t seed = 1; seed <= arguments_.seeds; ++seed)
        document_.runs.push_back(measureOne(map, method, seed));
    }
    finishTask();
  }
}

void Bench::measureRandomRooms(const BenchLibrary& library) {
  for (const BenchRoom& room : rooms_) {
    bench::BenchRun run =
        bench::measureWalk(*library.planner, room, bench::kGuidedMethod, room.scene.seed, arguments_.measure);
    run.library = library.name;
    document_.runs.push_back(std::move(run));
    finishTask();
  }
}

void Bench::measureGrowthOfFrames() {
  for (const std::size_t frames : arguments_.frames) {
    document_.growth.push_back(bench::growthAtFrames(frames, arguments_.measure));
    finishTask();
  }
}

/// With one library: the growth is that of the room.
void Bench::measureGrowthOfRooms(const BenchLibrary& library) {
  for (const std::size_t rectangles : arguments_.rectangles) {
    document_.growth.push_back(bench::growthAtRectangles(*library.planner, rectangles, arguments_.measure));
    finishTask();
  }
  for (const std::size_t walkers : arguments_.walkers) {
    document_.growth.push_back(bench::growthAtWalkers(*library.planner, walkers, arguments_.measure));
    finishTask();
  }
}

Result<void> Bench::join() {
  for (const std::string& path : arguments_.joinedPaths) {
    auto text = readFile(path, kMostReportBytes);
    if (!text) return fail(std::move(text));
    if (auto joined = joinBenchJson(*text, shownText(path), document_); !joined) return joined;
  }
  return {};
}

Result<BenchDocument> Bench::measure() {
  if (auto read = readRooms(); !read) return fail(std::move(read));
  tasks_ = taskCount();
  progress_.emplace("measuring", arguments_.isQuiet);
  makeRandomRooms();
  if (!arguments_.writtenFolder.empty()) {
    if (auto written = writeMapFolder(rooms_, arguments_.writtenFolder); !written)
      return fail(std::move(written));
  }
  measurePaths();
  for (std::size_t g = 0; g < arguments_.graphPaths.size(); ++g) {
    const auto library = openLibrary(arguments_.graphPaths[g]);
    if (!library) return tl::unexpected<Error>(library.error());
    measureWalks(*library);
    measureRandomRooms(*library);
    if (g == 0) measureGrowthOfRooms(*library);
  }
  measureGrowthOfFrames();
  progress_.reset();
  if (auto joined = join(); !joined) return fail(std::move(joined));
  return std::move(document_);
}

Result<void> writeResults(const BenchArguments& arguments, const BenchDocument& document) {
  const std::string tables = benchTables(document);
  OutputFiles files;
  Result<void> added;
  if (!arguments.jsonPath.empty()) added = files.add(arguments.jsonPath, writeBenchJson(document));
  if (added && !arguments.picturePath.empty())
    added = files.add(arguments.picturePath, benchPicture(document).finish());
  if (added && !arguments.markdownPath.empty()) added = files.add(arguments.markdownPath, tables);
  if (added) added = files.commit();
  // Results that could not be kept are still worth reading.
  print(stdout, tables);
  return added;
}

int runBench(const BenchArguments& arguments) {
  Result<void> done = checkBenchWork(arguments);
  if (done) done = checkBenchPaths(arguments);
  if (done) {
    printNotes(uselessOptions(arguments), arguments.isQuiet);
    const Result<BenchDocument> document = Bench(arguments).measure();
    done = document ? writeResults(arguments, *document) : tl::unexpected<Error>(document.error());
  }
  if (done) return kDone;
  complain("stridegraph bench", describe(done.error()));
  return kWrongUse;
}

}  // namespace

void addBenchCommand(CLI::App& program, Job& job) {
  CLI::App* command = program.add_subcommand("bench", "Measure speed and quality on maps and random rooms");
  auto arguments = std::make_shared<BenchArguments>();
  addBenchOptions(*command, arguments);
  command->callback([arguments, command, &job] {
    for (const CLI::Option* option : command->get_options({})) {
      if (option->count() > 0) arguments->given.push_back(option->get_name());
    }
    arguments->measure.clock = arguments->processorTime ? processorMillisecondsNow : millisecondsNow;
    job = [arguments] { return runBench(*arguments); };
  });
}

}  // namespace stridegraph::tools
