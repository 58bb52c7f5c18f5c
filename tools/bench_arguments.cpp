#include "bench_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "program/arguments.h"
#include "program/shown_text.h"

namespace stridegraph::tools {
namespace {

constexpr double kHourMilliseconds = 3'600'000.0;

void addMapOptions(CLI::App& command, const std::shared_ptr<BenchArguments>& arguments) {
  bench::MeasureParams& measure = arguments->measure;
  addPath(command, "--maps", arguments->mapsFolder, "FOLDER",
          "Scenes (JSON) to measure in, where there is one with shortest_paths.txt");
  command.add_option("--graph", arguments->graphPaths, "Library (.sgraph); may be given several times")
      ->type_name("FILE");
  addWhole(command, "--seeds", arguments->seeds, {1, 10'000, "seeds"}, "Of each map and method: 1 to this");
  const std::vector<std::string> known = arguments->methods;
  command
      .add_option_function<std::vector<std::string>>(
          "--methods",
          [arguments, known](const std::vector<std::string>& texts) {
            arguments->methods.clear();
            for (const std::string& text : texts) {
              std::istringstream names(text + ",");
              for (std::string name; std::getline(names, name, ',');)
                arguments->methods.push_back(choiceOrThrow("--methods", name, known));
            }
          },
          "What is measured on maps, with commas between")
      ->type_name("WORD,WORD")
      ->default_str(fmt::format("{}", fmt::join(known, ",")));
  addNumber(command, "--goal-radius", measure.goalRadiusMetres, {0.01, 5.0, "metres"},
            "How near the goal a search has to come");
  addNumber(command, "--thesis-ms", measure.thesisBudgetMilliseconds,
            {0.0, kHourMilliseconds, "milliseconds", true}, "When a search of the thesis is stopped");
  addNumber(command, "--improve-ms", measure.improveMilliseconds,
            {0.0, kHourMilliseconds, "milliseconds", true},
            "For how long guided-improved goes on after a first walk");
  addWhole(command, "--repeats", measure.repeats, {1, 1000, "times"},
           "Each run is made; the quickest counts");
  command.add_flag("--processor-time", arguments->processorTime,
                   "Measure what the processor spends, for machines that do other work, too");
}

void addRandomOptions(CLI::App& command, const std::shared_ptr<BenchArguments>& arguments) {
  addText(
      command, "--random",
      [arguments](const std::string& text) {
        arguments->randomSeed = wholeOrThrow("--random", text, kSeedRange);
      },
      "Also in random rooms of this seed: " + describe(kSeedRange))
      ->type_name("N");
  addWhole(command, "--rooms", arguments->rooms, {1, 100'000, "rooms"}, "How many random ones");
  addWhole(command, "--first-room", arguments->firstRoom, {0, 1'000'000'000, ""}, "Number of the first");
  addPath(command, "--write-scenes", arguments->writtenFolder, "FOLDER", "Write the random rooms as scenes");
}

void addGrowthOptions(CLI::App& command, const std::shared_ptr<BenchArguments>& arguments) {
  addWholeList(command, "--growth-frames", arguments->frames, {1, 1'000'000, "frames"},
               "Build libraries of so many, as 1000,10000");
  // Of more there is hardly a room with a way.
  addWholeList(command, "--growth-rectangles", arguments->rectangles, {0, 2000, "rectangles"},
               "Walk between so many with the first library, as 0,100");
  addWholeList(command, "--growth-walkers", arguments->walkers, {1, 101, "walkers"},
               "Let so many cross one square with the first library, as 1,10,100");
}

std::vector<NamedPath> inputsOf(const BenchArguments& arguments) {
  std::vector<NamedPath> inputs;
  for (const std::string& path : arguments.graphPaths) inputs.push_back({"--graph", path});
  for (const std::string& path : arguments.joinedPaths) inputs.push_back({"--join", path});
  return inputs;
}

}  // namespace

bool BenchArguments::asksFor(std::string_view method) const {
  return std::find(methods.begin(), methods.end(), method) != methods.end();
}

bool BenchArguments::isGiven(std::string_view option) const {
  return std::find(given.begin(), given.end(), option) != given.end();
}

void addBenchOptions(CLI::App& command, const std::shared_ptr<BenchArguments>& arguments) {
  addMapOptions(command, arguments);
  addRandomOptions(command, arguments);
  addGrowthOptions(command, arguments);
  command
      .add_option("--join", arguments->joinedPaths,
                  "What bench --json or node_bench.mjs wrote, tabulated together with this")
      ->type_name("FILE");
  addPath(command, "--json", arguments->jsonPath, "FILE", "Write every run");
  addPath(command, "--markdown", arguments->markdownPath, "FILE", "Write the tables");
  addPath(command, "--svg", arguments->picturePath, "FILE", "Write a picture");
  addQuiet(command, arguments->isQuiet);
}

Result<void> checkBenchWork(const BenchArguments& arguments) {
  const bool hasGraph = !arguments.graphPaths.empty();
  const bool hasRooms = arguments.randomSeed && (hasGraph || !arguments.writtenFolder.empty());
  const bool grows = !arguments.frames.empty() ||
                     (hasGraph && (!arguments.rectangles.empty() || !arguments.walkers.empty()));
  if (!arguments.mapsFolder.empty() || hasRooms || grows || !arguments.joinedPaths.empty()) return {};
  return fail(
      ErrorCode::kInvalidArgument,
      "found nothing to measure, expected one of: --maps FOLDER, alone for paths or with --graph FILE for "
      "walks; --graph FILE with --random SEED, --growth-rectangles N or --growth-walkers N; --random SEED "
      "with --write-scenes FOLDER; --growth-frames N; --join FILE");
}

Result<void> checkBenchPaths(const BenchArguments& arguments) {
  std::vector<NamedPath> outputs;
  if (!arguments.jsonPath.empty()) outputs.push_back({"--json", arguments.jsonPath});
  if (!arguments.markdownPath.empty()) outputs.push_back({"--markdown", arguments.markdownPath});
  if (!arguments.picturePath.empty()) outputs.push_back({"--svg", arguments.picturePath});
  if (auto checked = checkOutputs(inputsOf(arguments), outputs); !checked) return checked;
  const FileIdentity written(arguments.writtenFolder);
  if (arguments.writtenFolder.empty() || !written.isSameAs(FileIdentity(arguments.mapsFolder))) return {};
  return fail(ErrorCode::kFile,
              "--write-scenes would write among the scenes of --maps, expected another folder",
              {shownText(arguments.writtenFolder)});
}

Warnings uselessOptions(const BenchArguments& arguments) {
  Warnings notes;
  const auto needs = [&](bool isThere, std::string_view what, std::initializer_list<const char*> options) {
    for (const char* option : options) {
      if (!isThere && arguments.isGiven(option))
        notes.push_back({fmt::format("has no effect without {}", what), {option}, WarningTopic::kOther});
    }
  };
  const bool hasGraph = !arguments.graphPaths.empty();
  needs(arguments.randomSeed.has_value(), "--random", {"--rooms", "--first-room", "--write-scenes"});
  needs(!arguments.mapsFolder.empty(), "--maps", {"--seeds", "--methods"});
  needs(hasGraph, "--graph", {"--growth-rectangles", "--growth-walkers"});
  needs(hasGraph || !arguments.writtenFolder.empty(), "--graph or --write-scenes", {"--random"});
  needs(hasGraph || !arguments.mapsFolder.empty(), "--maps or --graph", {"--repeats"});
  const bool walks = hasGraph && !arguments.mapsFolder.empty();
  needs(walks && (arguments.asksFor("thesis") || arguments.asksFor("thesis-checked")),
        "--maps, --graph and a method of the thesis", {"--thesis-ms"});
  needs(walks && arguments.asksFor("guided-improved"), "--maps, --graph and the method guided-improved",
        {"--improve-ms"});
  return notes;
}

}  // namespace stridegraph::tools
