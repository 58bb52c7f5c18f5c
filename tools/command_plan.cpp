#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "commands.h"
#include "files.h"
#include "graph/sgraph_file.h"
#include "motion/bvh_writer.h"
#include "motion/glb_writer.h"
#include "scene/scene_json.h"
#include "walk/walk_planner.h"
#include "wall_clock.h"

namespace stridegraph::tools {
namespace {

struct PlanArguments {
  std::string graphPath;
  std::string scenePath;
  std::string walkPath;
  std::string reportPath;
  std::uint64_t seed = 0;
  double radiusMetres = 0.0;
  std::string planner = "prm";
  std::string search = "guided";
  bool movingEnds = false;
  bool rawFeet = false;
  PlanOptions options;
};

Result<Plan> makePlan(const PlanArguments& arguments, std::shared_ptr<const MotionLibrary>& library) {
  auto graphText = readFile(arguments.graphPath);
  if (!graphText) return fail(std::move(graphText));
  auto read = readSgraph(bytesOf(*graphText));
  if (!read) {
    read.error().place.file = arguments.graphPath;
    return fail(std::move(read));
  }
  library = std::make_shared<const MotionLibrary>(std::move(*read));
  auto sceneText = readFile(arguments.scenePath);
  if (!sceneText) return fail(std::move(sceneText));
  auto scene = readSceneJson(*sceneText, arguments.scenePath);
  if (!scene) return fail(std::move(scene));
  return WalkPlanner(library).plan(*scene, arguments.options);
}

bool holdsAllWalks(const std::string& path) {
  return path.ends_with(".glb");
}

/// WALK.bvh for the first walker, WALK_2.bvh, WALK_3.bvh ... for the others; WALK.glb for all.
std::string walkPathOf(const std::string& path, std::size_t walker) {
  if (walker == 0 || holdsAllWalks(path)) return path;
  const std::size_t ending = path.rfind('.');
  return fmt::format("{}_{}{}", path.substr(0, ending), walker + 1, path.substr(ending));
}

/// The first walker's plan, then those of the others.
std::vector<const Plan*> allOf(const Plan& plan) {
  std::vector<const Plan*> all = {&plan};
  for (const Plan& other : plan.others) all.push_back(&other);
  return all;
}

bool arrived(const Plan& plan) {
  return plan.report.status == PlanStatus::kArrived;
}

Result<void> writeWalks(const std::string& path, const MotionLibrary& library, const Plan& plan) {
  const std::vector<const Plan*> all = allOf(plan);
  std::vector<WalkerClip> together;
  for (std::size_t walker = 0; walker < all.size(); ++walker) {
    if (!arrived(*all[walker])) continue;
    together.push_back({&all[walker]->walk, walker});
    if (holdsAllWalks(path)) continue;
    const std::string text = writeBvh(library.skeleton, library.layout, all[walker]->walk);
    if (Result<void> written = writeFile(walkPathOf(path, walker), text); !written) return written;
  }
  if (!holdsAllWalks(path) || together.empty()) return {};
  const RoundBody body = roundBody(library.skeleton, library.frames);
  return writeFile(path, writeGlb(library.skeleton, body, together));
}

Result<void> writeFiles(const PlanArguments& arguments, const MotionLibrary& library, const Plan& plan) {
  if (Result<void> written = writeWalks(arguments.walkPath, library, plan); !written) return written;
  if (arguments.reportPath.empty()) return {};
  return writeFile(arguments.reportPath, toJson(plan) + "\n");
}

void printWalk(const std::string& path, const PlanReport& report) {
  fmt::print("{}: {} frames, {:.1f} s, {:.2f} m walked along a path of {:.2f} m, {} transitions, {:.1f} ms\n",
             path, report.frames, report.durationSeconds, report.motionLengthMetres, report.pathLengthMetres,
             report.transitions, report.totalMilliseconds);
}

int runPlan(const PlanArguments& arguments) {
  std::shared_ptr<const MotionLibrary> library;
  const Result<Plan> plan = makePlan(arguments, library);
  if (!plan) {
    fmt::print(stderr, "stridegraph plan: {}\n", describe(plan.error()));
    return kWrongUse;
  }
  if (const Result<void> written = writeFiles(arguments, *library, *plan); !written) {
    fmt::print(stderr, "stridegraph plan: {}\n", describe(written.error()));
    return kWrongUse;
  }
  const std::vector<const Plan*> all = allOf(*plan);
  int exitCode = kDone;
  for (std::size_t walker = 0; walker < all.size(); ++walker) {
    const PlanReport& report = all[walker]->report;
    const std::string who = all.size() > 1 ? fmt::format("walker {}: ", walker + 1) : "";
    if (!arrived(*all[walker])) {
      fmt::print(stderr, "stridegraph plan: {}{}: {}\n", who, planStatusName(report.status),
                 report.explanation);
      exitCode = kRefused;
      continue;
    }
    printWalk(walkPathOf(arguments.walkPath, walker), report);
    if (!report.explanation.empty()) fmt::print(stderr, "note: {}{}\n", who, report.explanation);
  }
  return exitCode;
}

}  // namespace

void addPlanCommand(CLI::App& program, int& exitCode) {
  CLI::App* command =
      program.add_subcommand("plan", "Plan a walk through a scene and write it as BVH or GLB");
  auto arguments = std::make_shared<PlanArguments>();
  command->add_option("--graph", arguments->graphPath, "Library (.sgraph)")->required();
  command->add_option("--scene", arguments->scenePath, "Scene (JSON)")->required();
  command
      ->add_option("-o,--output", arguments->walkPath,
                   "Walk to write: .bvh, further walkers' as WALK_2.bvh, WALK_3.bvh ..., or .glb with all")
      ->required()
      ->check([](const std::string& path) {
        return path.ends_with(".bvh") || path.ends_with(".glb")
                   ? std::string()
                   : "found " + path + ", expected a name ending in .bvh or .glb";
      });
  CLI::Option* seed = command->add_option("--seed", arguments->seed, "Instead of the scene's seed");
  CLI::Option* radius = command->add_option("--radius", arguments->radiusMetres,
                                            "Of the body's disc, metres, instead of the scene's");
  command
      ->add_option("--goal-radius", arguments->options.goalRadiusMetres,
                   "How near the goal the search has to come, metres")
      ->capture_default_str();
  command->add_flag("--moving-ends", arguments->movingEnds,
                    "Begin and end in motion even where the library can stand");
  command->add_option("--planner", arguments->planner)
      ->check(CLI::IsMember({"prm", "rrt-connect"}))
      ->capture_default_str();
  command->add_option("--search", arguments->search)
      ->check(CLI::IsMember({"guided", "thesis", "thesis-checked"}))
      ->capture_default_str();
  command
      ->add_option("--budget-ms", arguments->options.budgetMilliseconds,
                   "Time for the motion search; 0: no limit")
      ->capture_default_str();
  command
      ->add_option("--improve", arguments->options.improvementExpansions,
                   "States to look at beyond the first walk's, to find a better one: 20000 take 20 to 50 ms")
      ->capture_default_str();
  command->add_option("--until", arguments->options.enoughRatio,
                      "Improve no further once the walk is at most so many times as long as a disc's way");
  command->add_flag("--raw-feet", arguments->rawFeet,
                    "Leave feet as blended, to compare: no pins, no lifting");
  command->add_option("--report", arguments->reportPath, "Write the report (JSON)");
  command->callback([arguments, seed, radius, &exitCode] {
    PlanOptions& options = arguments->options;
    if (seed->count() > 0) options.seed = arguments->seed;
    if (radius->count() > 0) options.radiusMetres = arguments->radiusMetres;
    options.standing = !arguments->movingEnds;
    options.footCleanup = !arguments->rawFeet;
    options.planner = *plannerFromName(arguments->planner);
    options.search = *searchFromName(arguments->search);
    options.clock = millisecondsNow;
    exitCode = runPlan(*arguments);
  });
}

}  // namespace stridegraph::tools
