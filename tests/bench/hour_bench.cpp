// Builds a library from an hour of motion (108,000 frames at 30 Hz unless told otherwise) and says how long
// each part took; /usr/bin/time -v says how much memory.
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>

#include "bench/varied_clips.h"
#include "graph/library_builder.h"
#include "graph/sgraph_file.h"

int main(int argumentCount, char** arguments) {
  using namespace stridegraph;
  const std::size_t frames = argumentCount > 1 ? std::strtoull(arguments[1], nullptr, 10) : 108'000;
  const std::uint64_t seed = argumentCount > 2 ? std::strtoull(arguments[2], nullptr, 10) : 1;
  const auto begin = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  auto clips = bench::variedGaitClips(frames, seed);
  fmt::print("{:8.2f} s: {} clips\n", seconds(), clips.size());
  auto builder = LibraryBuilder::start(std::move(clips), {});
  if (!builder) {
    fmt::print(stderr, "{}\n", describe(builder.error()));
    return EXIT_FAILURE;
  }
  double said = 0.0;
  while (builder->step()) {
    if (builder->progress() < said + 0.1) continue;
    said = builder->progress();
    fmt::print("{:8.2f} s: {:.0f} %\n", seconds(), 100.0 * said);
  }
  const auto library = builder->finish();
  if (!library) {
    fmt::print(stderr, "{}\n", describe(library.error()));
    return EXIT_FAILURE;
  }
  const BuildReport& report = builder->report();
  fmt::print("{:8.2f} s: {} frames, {} pairs, {} regions, {} nodes, {} transitions, {:.0f} % of the frames\n",
             seconds(), library->frames.frameCount(), report.framePairs, library->regions.size(),
             report.nodes, report.transitions, 100.0 * report.survivingShare);
  fmt::print("{:8.2f} s: {} bytes of .sgraph\n", seconds(), writeSgraph(*library).size());
  return EXIT_SUCCESS;
}
