#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "bench/document_json.h"
#include "bench/growth.h"
#include "bench/measuring.h"
#include "bench/picture.h"
#include "bench/random_room.h"
#include "bench/tables.h"
#include "commands.h"
#include "files.h"
#include "graph/sgraph_file.h"
#include "map_folder.h"
#include "wall_clock.h"

namespace stridegraph::tools {
namespace {

using bench::BenchDocument;
using bench::BenchRoom;

struct BenchArguments {
  std::string mapsFolder;
  std::vector<std::string> graphPaths;
  std::vector<std::string> methods = {"exact",           "prm",    "rrt-connect",   "guided",
                                      "guided-improved", "thesis", "thesis-checked"};
  std::uint64_t seeds = 20;
  std::optional<std::uint64_t> randomSeed;
  std::uint64_t firstRoom = 1;
  std::uint64_t rooms = 1000;
  std::string writtenFolder;
  std::vector<std::size_t> frames;
  std::vector<std::size_t> rectangles;
  std::vector<std::size_t> walkers;
  std::vector<std::string> joinedPaths;
  std::string jsonPath;
  std::string markdownPath;
  std::string picturePath;
  bool processorTime = false;
  bench::MeasureParams measure;

  bool asksFor(std::string_view method) const {
    return std::find(methods.begin(), methods.end(), method) != methods.end();
  }
};

void say(const std::string& line) {
  fmt::print(stderr, "{}\n", line);
}

std::vector<BenchRoom> makeRandomRooms(const BenchArguments& arguments) {
  std::vector<BenchRoom> rooms;
  if (!arguments.randomSeed) return rooms;
  for (std::uint64_t i = 0; i < arguments.rooms; ++i) {
    const std::uint64_t number = arguments.firstRoom + i;
    rooms.push_back({bench::kRandomSet,
                     fmt::format("room_{:04}", number),
                     bench::randomRoom(*arguments.randomSeed, number),
                     {}});
    noteShortest(rooms.back());
  }
  return rooms;
}

struct BenchLibrary {
  std::string name;
  std::unique_ptr<const WalkPlanner> planner;
};

Result<BenchLibrary> openLibrary(const std::string& path) {
  auto text = readFile(path);
  if (!text) return fail(std::move(text));
  auto library = readSgraph(bytesOf(*text));
  if (!library) {
    library.error().place.file = path;
    return fail(std::move(library));
  }
  return BenchLibrary{
      std::filesystem::path(path).stem().string(),
      std::make_unique<WalkPlanner>(std::make_shared<const MotionLibrary>(std::move(*library)))};
}

void measurePaths(const BenchArguments& arguments, const std::vector<BenchRoom>& maps,
                  BenchDocument& document) {
  for (const BenchRoom& map : maps) {
    for (const bench::PathMethod& method : bench::pathMethods()) {
      if (!arguments.asksFor(method.name)) continue;
      const std::uint64_t seeds =
          method.seeded ? arguments.seeds : std::min<std::uint64_t>(arguments.seeds, 1);
      for (std::uint64_t seed = 1; seed <= seeds; ++seed)
        document.runs.push_back(bench::measurePath(method, map, seed, arguments.measure));
    }
    say(fmt::format("paths: {}", map.name));
  }
}

void measureWalks(const BenchArguments& arguments, const BenchLibrary& library,
                  const std::vector<BenchRoom>& maps, BenchDocument& document) {
  const auto measure = [&](const BenchRoom& room, const bench::WalkMethod& method, std::uint64_t seed) {
    bench::BenchRun run = bench::measureWalk(*library.planner, room, method, seed, arguments.measure);
    run.library = library.name;
    return run;
  };
  for (const BenchRoom& map : maps) {
    for (const bench::WalkMethod& method : bench::walkMethods()) {
      if (!arguments.asksFor(method.name)) continue;
      measure(map, method, 0);  // Caches and memory are warm from here on.
      for (std::uint64_t seed = 1; seed <= arguments.seeds; ++seed)
        document.runs.push_back(measure(map, method, seed));
    }
    say(fmt::format("{}: {}", library.name, map.name));
  }
}

void measureRandomRooms(const BenchArguments& arguments, const BenchLibrary& library,
                        const std::vector<BenchRoom>& rooms, BenchDocument& document) {
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    bench::BenchRun run = bench::measureWalk(*library.planner, rooms[i], bench::kGuidedMethod,
                                             rooms[i].scene.seed, arguments.measure);
    run.library = library.name;
    document.runs.push_back(std::move(run));
    if ((i + 1) % 100 == 0) say(fmt::format("{}: {} random rooms", library.name, i + 1));
  }
}

void measureGrowthOfFrames(const BenchArguments& arguments, BenchDocument& document) {
  for (const std::size_t frames : arguments.frames) {
    document.growth.push_back(bench::growthAtFrames(frames, arguments.measure));
    say(fmt::format("growth: {} frames", frames));
  }
}

/// With one library: the growth is that of the room.
void measureGrowthOfRooms(const BenchArguments& arguments, const BenchLibrary& library,
                          BenchDocument& document) {
  for (const std::size_t rectangles : arguments.rectangles) {
    document.growth.push_back(bench::growthAtRectangles(*library.planner, rectangles, arguments.measure));
    say(fmt::format("growth: {} rectangles", rectangles));
  }
  for (const std::size_t walkers : arguments.walkers) {
    document.growth.push_back(bench::growthAtWalkers(*library.planner, walkers, arguments.measure));
    say(fmt::format("growth: {} walkers", walkers));
  }
}

Result<BenchDocument> measureAll(const BenchArguments& arguments) {
  BenchDocument document;
  Result<std::vector<BenchRoom>> maps;
  if (!arguments.mapsFolder.empty()) maps = readMapFolder(arguments.mapsFolder);
  if (!maps) return fail(std::move(maps));
  const std::vector<BenchRoom> rooms = makeRandomRooms(arguments);
  if (!arguments.writtenFolder.empty()) {
    if (auto written = writeMapFolder(rooms, arguments.writtenFolder); !written)
      return fail(std::move(written));
  }
  measurePaths(arguments, *maps, document);
  for (const std::string& path : arguments.graphPaths) {
    const auto library = openLibrary(path);
    if (!library) return tl::unexpected<Error>(library.error());
    measureWalks(arguments, *library, *maps, document);
    measureRandomRooms(arguments, *library, rooms, document);
    if (path == arguments.graphPaths.front()) measureGrowthOfRooms(arguments, *library, document);
  }
  measureGrowthOfFrames(arguments, document);
  for (const std::string& path : arguments.joinedPaths) {
    auto text = readFile(path);
    if (!text) return fail(std::move(text));
    if (auto joined = joinBenchJson(*text, path, document); !joined) return fail(std::move(joined));
  }
  return document;
}

Result<void> writeResults(const BenchArguments& arguments, const BenchDocument& document) {
  const std::string tables = benchTables(document);
  fmt::print("{}", tables);
  if (!arguments.jsonPath.empty()) {
    if (auto written = writeFile(arguments.jsonPath, writeBenchJson(document)); !written) return written;
  }
  if (!arguments.picturePath.empty()) {
    const std::string picture = benchPicture(document).finish();
    if (auto written = writeFile(arguments.picturePath, picture); !written) return written;
  }
  if (arguments.markdownPath.empty()) return {};
  return writeFile(arguments.markdownPath, tables);
}

int runBench(const BenchArguments& arguments) {
  const Result<BenchDocument> document = measureAll(arguments);
  const Result<void> written =
      document ? writeResults(arguments, *document) : tl::unexpected<Error>(document.error());
  if (written) return kDone;
  fmt::print(stderr, "stridegraph bench: {}\n", describe(written.error()));
  return kWrongUse;
}

}  // namespace

void addBenchCommand(CLI::App& program, int& exitCode) {
  CLI::App* command = program.add_subcommand("bench", "Measure speed and quality on maps and random rooms");
  auto arguments = std::make_shared<BenchArguments>();
  bench::MeasureParams& measure = arguments->measure;
  command->add_option("--maps", arguments->mapsFolder,
                      "Folder of scenes (JSON), where there is one with shortest_paths.txt");
  command->add_option("--graph", arguments->graphPaths, "Library (.sgraph); may be given several times");
  command->add_option("--seeds", arguments->seeds, "Of each map and method: 1 to this")
      ->capture_default_str();
  command->add_option("--methods", arguments->methods, "What is measured on maps")
      ->delimiter(',')
      ->check(CLI::IsMember(arguments->methods))
      ->capture_default_str();
  command->add_option("--goal-radius", measure.goalRadiusMetres, "Metres")->capture_default_str();
  command
      ->add_option("--thesis-ms", measure.thesisBudgetMilliseconds,
                   "When a search of the thesis is stopped, milliseconds")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command
      ->add_option("--improve-ms", measure.improveMilliseconds,
                   "For how long guided-improved goes on after a first walk, milliseconds")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--repeats", measure.repeats, "Times each run is made; the quickest counts")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_flag("--processor-time", arguments->processorTime,
                    "Measure what the processor spends, for machines that do other work, too");
  command->add_option("--random", arguments->randomSeed, "Also in random rooms of this seed");
  command->add_option("--rooms", arguments->rooms, "How many random rooms")->capture_default_str();
  command->add_option("--first-room", arguments->firstRoom, "Number of the first")->capture_default_str();
  command->add_option("--write-scenes", arguments->writtenFolder, "Folder for the random rooms as scenes");
  command
      ->add_option("--growth-frames", arguments->frames,
                   "Numbers of frames to build libraries from, as 1000,10000")
      ->delimiter(',');
  command
      ->add_option("--growth-rectangles", arguments->rectangles,
                   "Numbers of rectangles to walk between with the first library, as 0,100")
      ->delimiter(',');
  command
      ->add_option("--growth-walkers", arguments->walkers,
                   "Numbers of walkers to cross one square with the first library, as 1,10,100")
      ->delimiter(',')
      ->check(CLI::PositiveNumber);
  command->add_option("--join", arguments->joinedPaths,
                      "What bench --json or node_bench.mjs wrote, tabulated together with this");
  command->add_option("--json", arguments->jsonPath, "Write every run");
  command->add_option("--markdown", arguments->markdownPath, "Write the tables");
  command->add_option("--svg", arguments->picturePath, "Write a picture");
  command->callback([arguments, &exitCode] {
    arguments->measure.clock = arguments->processorTime ? processorMillisecondsNow : millisecondsNow;
    exitCode = runBench(*arguments);
  });
}

}  // namespace stridegraph::tools
