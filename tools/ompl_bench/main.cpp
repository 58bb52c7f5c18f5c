// Measures OMPL's planners on a folder of maps, in the form that `stridegraph bench --join` reads.
#include <fmt/format.h>

#include "bench/document_json.h"
#include "map_folder.h"
#include "ompl_bench/ompl_planners.h"
#include "program/arguments.h"
#include "program/output_files.h"
#include "program/run_program.h"
#include "program/shown_text.h"
#include "wall_clock.h"

using namespace stridegraph;

namespace {

struct Arguments {
  std::string mapsFolder;
  std::string outputPath;
  std::uint64_t seeds = 20;
  bench::OmplParams planners;
};

Result<void> measure(const Arguments& arguments) {
  auto maps = tools::readMapFolder(arguments.mapsFolder);
  if (!maps) return fail(std::move(maps));
  bench::MeasureParams params;
  params.clock = tools::millisecondsNow;
  bench::BenchDocument document;
  for (const bench::BenchRoom& map : *maps) {
    for (const bench::PathMethod& method : bench::omplMethods(arguments.planners)) {
      for (std::uint64_t seed = 1; seed <= arguments.seeds; ++seed)
        document.runs.push_back(bench::measurePath(method, map, seed, params));
    }
    tools::printLine(stderr, fmt::format("OMPL: {}", map.name));
  }
  return tools::writeFile(arguments.outputPath, bench::writeBenchJson(document));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program{"Measures OMPL's PRM, RRT-Connect and BIT* on maps.", "ompl_bench"};
  Arguments arguments;
  arguments.planners.clock = tools::millisecondsNow;
  constexpr tools::NumberRange kTime{0.0, 3'600'000.0, "milliseconds", true};
  tools::addPath(program, "--maps", arguments.mapsFolder, "FOLDER", "Scenes (JSON)")->required();
  tools::addWhole(program, "--seeds", arguments.seeds, {1, 10'000, "seeds"},
                  "Of each map and planner: 1 to this");
  tools::addNumber(program, "--most-ms", arguments.planners.mostMilliseconds, kTime,
                   "When a planner is stopped");
  tools::addNumber(program, "--improve-ms", arguments.planners.improveMilliseconds, kTime,
                   "For how long BIT* improves its path");
  tools::addPath(program, "-o,--output", arguments.outputPath, "FILE", "Runs (JSON)")->required();
  tools::Job job;
  program.callback([&] {
    job = [&]() -> int {
      const Result<void> measured = measure(arguments);
      if (measured) return tools::kDone;
      tools::complain("ompl_bench", describe(measured.error()));
      return tools::kWrongUse;
    };
  });
  return tools::runProgram(program, argc, argv, job);
}
