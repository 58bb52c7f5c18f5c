// What `stridegraph build --append` saves: a few clips more, at once with all others or appended to a
// library.
#include <benchmark/benchmark.h>

#include "bench/varied_clips.h"
#include "graph/library_builder.h"

namespace stridegraph::bench {
namespace {

constexpr std::size_t kNewClips = 4;

std::vector<BvhDocument> clipsOf(const benchmark::State& state) {
  return variedGaitClips(static_cast<std::size_t>(state.range(0)), 1);
}

void run(benchmark::State& state, Result<LibraryBuilder> builder) {
  while (builder->step()) {
  }
  state.counters["pairs"] = static_cast<double>(builder->report().framePairs);
  benchmark::DoNotOptimize(builder->finish()->hash);
}

void buildAtOnce(benchmark::State& state) {
  const std::vector<BvhDocument> clips = clipsOf(state);
  for ([[maybe_unused]] auto _ : state) run(state, LibraryBuilder::start(clips, {}));
}

void append(benchmark::State& state) {
  const std::vector<BvhDocument> clips = clipsOf(state);
  const auto middle = clips.end() - kNewClips;
  const MotionLibrary library = buildLibrary({clips.begin(), middle})->library;
  for ([[maybe_unused]] auto _ : state) run(state, LibraryBuilder::append(library, {middle, clips.end()}));
}

BENCHMARK(buildAtOnce)->Arg(5'000)->Arg(20'000)->Unit(benchmark::kMillisecond);
BENCHMARK(append)->Arg(5'000)->Arg(20'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace stridegraph::bench

BENCHMARK_MAIN();
