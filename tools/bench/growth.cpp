#include "bench/growth.h"

#include <fmt/format.h>

#include <memory>

#include "bench/crossing.h"
#include "bench/random_room.h"
#include "bench/summary.h"
#include "bench/varied_clips.h"
#include "graph/library_builder.h"
#include "graph/sgraph_file.h"
#include "path/connectivity.h"

namespace stridegraph::bench {
namespace {

constexpr std::uint64_t kRoomSeed = 1;
constexpr std::uint64_t kRooms = 7;

/// Runs of the guided search through the first rooms of that kind.
std::vector<BenchRun> walksThrough(const WalkPlanner& planner, const RandomRoomParams& rooms,
                                   const MeasureParams& params) {
  std::vector<BenchRun> runs;
  for (std::uint64_t number = 1; number <= kRooms; ++number) {
    const BenchRoom room{kRandomSet, fmt::format("{}", number), randomRoom(kRoomSeed, number, rooms), {}};
    runs.push_back(measureWalk(planner, room, kGuidedMethod, 1, params));
  }
  return runs;
}

template <typename Figure>
double medianOf(const std::vector<BenchRun>& runs, const Figure& figure) {
  std::vector<double> values;
  for (const BenchRun& run : runs) values.push_back(figure(run));
  return spreadOf(std::move(values)).median;
}

/// The time to make a room ready and to decide whether there is a way, milliseconds.
std::pair<double, double> timesOfRoom(const RandomRoomParams& kind, const MeasureParams& params) {
  std::vector<double> ready;
  std::vector<double> decided;
  for (std::uint64_t number = 1; number <= kRooms; ++number) {
    const Scene room = randomRoom(kRoomSeed, number, kind);
    const double begin = params.clock();
    const FloorPlan plan(room, room.radiusMetres);
    const double middle = params.clock();
    const bool connected = isConnected(plan, room.start.position, room.goal.position);
    decided.push_back(connected ? params.clock() - middle : 0.0);
    ready.push_back(middle - begin);
  }
  return {spreadOf(std::move(ready)).median, spreadOf(std::move(decided)).median};
}

}  // namespace

GrowthRow growthAtFrames(std::size_t frames, const MeasureParams& params) {
  GrowthRow row{"native", "frames", static_cast<double>(frames), {}};
  std::vector<BvhDocument> clips = variedGaitClips(frames, 1);
  const double begin = params.clock();
  auto builder = LibraryBuilder::start(std::move(clips), {});
  if (!builder) return row;
  while (builder->step()) {
  }
  const auto built = builder->finish();
  const double seconds = 1e-3 * (params.clock() - begin);
  if (!built) return row;
  const BuildReport& report = builder->report();
  const std::vector<std::uint8_t> bytes = writeSgraph(*built);
  const double opening = params.clock();
  auto opened = readSgraph(bytes);
  const WalkPlanner planner(std::make_shared<const MotionLibrary>(std::move(*opened)));
  const double ready = params.clock();
  const std::vector<BenchRun> runs = walksThrough(planner, {}, params);
  row.figures = {{"build s", seconds},
                 {"million pairs", 1e-6 * static_cast<double>(report.framePairs)},
                 {"nodes", static_cast<double>(report.nodes)},
                 {"transitions found", static_cast<double>(report.transitionsBeforeThinning)},
                 {"transitions", static_cast<double>(report.transitions)},
                 {"file MB", 1e-6 * static_cast<double>(bytes.size())},
                 {"open ms", ready - opening},
                 {"walk ms", medianOf(runs, [](const BenchRun& run) { return run.totalMilliseconds; })}};
  return row;
}

GrowthRow growthAtRectangles(const WalkPlanner& planner, std::size_t rectangles,
                             const MeasureParams& params) {
  RandomRoomParams kind;
  kind.leastSideMetres = kind.mostSideMetres = 120.0;
  kind.mostBlockMetres = 1.5;
  kind.mostWallMetres = 0.0;
  kind.rectangles = rectangles;
  const auto [readyMilliseconds, decidedMilliseconds] = timesOfRoom(kind, params);
  const std::vector<BenchRun> runs = walksThrough(planner, kind, params);
  return {"native",
          "rectangles",
          static_cast<double>(rectangles),
          {{"room ms", readyMilliseconds},
           {"is there a way ms", decidedMilliseconds},
           {"path ms", medianOf(runs, [](const BenchRun& run) { return run.pathMilliseconds; })},
           {"motion ms", medianOf(runs, [](const BenchRun& run) { return run.motionMilliseconds; })},
           {"synthesis ms", medianOf(runs, [](const BenchRun& run) { return run.synthesisMilliseconds; })},
           {"walk ms", medianOf(runs, [](const BenchRun& run) { return run.totalMilliseconds; })}}};
}

GrowthRow growthAtWalkers(const WalkPlanner& planner, std::size_t walkers, const MeasureParams& params) {
  GrowthRow row{"native", "walkers", static_cast<double>(walkers), {}};
  const Scene scene = crossingScene(walkers);
  PlanOptions options;
  options.goalRadiusMetres = params.goalRadiusMetres;
  options.clock = params.clock;
  const double begin = params.clock();
  const Result<Plan> plan = planner.plan(scene, options);
  const double milliseconds = params.clock() - begin;
  if (!plan) return row;
  const Crossing crossing = crossingOf(scene, *plan);
  row.figures = {{"arrived", static_cast<double>(crossing.arrived)},
                 {"all ms", milliseconds},
                 {"slowest walker ms", crossing.slowestMilliseconds},
                 {"frames of contact", static_cast<double>(crossing.contactFrames)},
                 {"mean length / shortest", crossing.meanLengthRatio}};
  // A single walker has no other to come near to.
  if (walkers > 1) row.figures.emplace_back("least gap m", crossing.leastGapMetres);
  return row;
}

}  // namespace stridegraph::bench
