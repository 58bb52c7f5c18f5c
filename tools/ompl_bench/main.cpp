// Measures OMPL's planners on a folder of maps, in the form that `stridegraph bench --join` reads.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "bench/document_json.h"
#include "commands.h"
#include "files.h"
#include "map_folder.h"
#include "ompl_bench/ompl_planners.h"
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
    fmt::print(stderr, "OMPL: {}\n", map.name);
  }
  return tools::writeFile(arguments.outputPath, bench::writeBenchJson(document));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program{"Measures OMPL's PRM, RRT-Connect and BIT* on maps."};
  Arguments arguments;
  arguments.planners.clock = tools::millisecondsNow;
  program.add_option("--maps", arguments.mapsFolder, "Folder of scenes (JSON)")->required();
  program.add_option("--seeds", arguments.seeds, "Of each map and planner: 1 to this")->capture_default_str();
  program.add_option("--most-ms", arguments.planners.mostMilliseconds, "When a planner is stopped")
      ->capture_default_str();
  program
      .add_option("--improve-ms", arguments.planners.improveMilliseconds,
                  "For how long BIT* improves its path")
      ->capture_default_str();
  program.add_option("-o,--output", arguments.outputPath, "Runs (JSON)")->required();
  CLI11_PARSE(program, argc, argv);
  const Result<void> measured = measure(arguments);
  if (measured) return tools::kDone;
  fmt::print(stderr, "ompl_bench: {}\n", describe(measured.error()));
  return tools::kWrongUse;
}
