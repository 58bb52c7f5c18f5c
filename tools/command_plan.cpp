#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "commands.h"
#include "library_file.h"
#include "notes.h"
#include "plan_arguments.h"
#include "program/files.h"
#include "program/json_document.h"
#include "program/progress.h"
#include "program/shown_text.h"
#include "scene/scene_json.h"
#include "scene/scene_limits.h"
#include "walk/walk_planner.h"
#include "walk_files.h"
#include "wall_clock.h"

namespace stridegraph::tools {
namespace {

/// A plan with what it was made from.
struct Planned {
  std::shared_ptr<const MotionLibrary> library;
  std::string sceneName;
  Plan plan;
};

std::vector<NamedPath> inputsOf(const PlanArguments& arguments) {
  return {{"--graph", arguments.graphPath}, {"--scene", arguments.scenePath}};
}

std::vector<NamedPath> outputsOf(const PlanArguments& arguments, std::size_t walkers) {
  std::vector<NamedPath> outputs = WalkFiles(arguments.walkPath).outputs(walkers);
  if (!arguments.reportPath.empty()) outputs.push_back({"--report", arguments.reportPath});
  return outputs;
}

Result<Scene> readScene(const PlanArguments& arguments, Warnings& notes) {
  auto text = readFile(arguments.scenePath, kMostSceneBytes);
  if (!text) return fail(std::move(text));
  return readSceneJson(*text, shownText(arguments.scenePath), &notes);
}

/// Plans while showing progress: first by the time that a budget allows, then by what improving allows.
Result<Plan> planWithProgress(const WalkPlanner& planner, const Scene& scene,
                              const PlanArguments& arguments) {
  // Some tens of milliseconds of search.
  constexpr std::uint64_t kSlice = 20'000;
  Progress progress("planning", arguments.isQuiet);
  PlanOptions options = arguments.options;
  // The search asks for the time now and then, which is when its share of the budget can be shown.
  options.clock = [&progress, budget = options.budgetMilliseconds] {
    if (budget > 0.0) progress.at(progress.milliseconds() / budget);
    return millisecondsNow();
  };
  auto plan = planner.begin(scene, options);
  if (!plan) return fail(std::move(plan));
  while (!plan->isDone()) {
    plan->step(kSlice);
    if (options.budgetMilliseconds <= 0.0) progress.at(plan->progress());
  }
  Plan best = std::move(*plan).best();
  // The clock shows the progress of this planning alone.
  best.options.clock = {};
  for (Plan& other : best.others) other.options.clock = {};
  return best;
}

/// Options that make no difference with this library, and parts of the scene that make none with these
/// options.
void noteWhatIsNotHeeded(const PlanArguments& arguments, const MotionLibrary& library, const Scene& scene,
                         Warnings& notes) {
  if (!arguments.options.footCleanup && library.contactJoints.empty()) {
    notes.push_back(
        {"has no effect, since the library's feet are not known", {"--raw-feet"}, WarningTopic::kOther});
  }
  if (arguments.options.search == SearchKind::kGuided) return;
  if (!scene.moving.empty() || !scene.walkers.empty() || scene.constraints.any()) {
    notes.push_back({"heeds neither what moves nor constraints, which the scene has",
                     {fmt::format("--search {}", searchName(arguments.options.search))},
                     WarningTopic::kScene});
  }
}

Result<Planned> makePlan(const PlanArguments& arguments, Warnings& notes) {
  auto library = readLibraryFile(arguments.graphPath);
  if (!library) return fail(std::move(library));
  auto scene = readScene(arguments, notes);
  if (!scene) return fail(std::move(scene));
  if (auto checked = checkOutputs(inputsOf(arguments), outputsOf(arguments, 1 + scene->walkers.size()));
      !checked)
    return fail(std::move(checked));
  noteWhatIsNotHeeded(arguments, *library, *scene, notes);
  auto shared = std::make_shared<const MotionLibrary>(std::move(*library));
  auto plan = planWithProgress(WalkPlanner(shared), *scene, arguments);
  if (!plan) return fail(std::move(plan));
  return Planned{std::move(shared), scene->name, std::move(*plan)};
}

/// The plan's report with the scene's name and the notes.
std::string reportText(const Planned& planned, const Warnings& notes) {
  Json json = Json::parse(toJson(planned.plan));
  json["scene"] = planned.sceneName;
  json["notes"] = notesJson(notes);
  return documentText(json);
}

Result<void> writeFiles(const PlanArguments& arguments, const Planned& planned, const Warnings& notes) {
  OutputFiles files;
  Result<void> added = WalkFiles(arguments.walkPath).addTo(files, *planned.library, allOf(planned.plan));
  if (added && !arguments.reportPath.empty())
    added = files.add(arguments.reportPath, reportText(planned, notes));
  return added ? files.commit() : added;
}

void printWalk(std::FILE* stream, const std::string& path, const PlanReport& report) {
  printLine(stream,
            fmt::format("{}: {} frames, {:.1f} s, {:.2f} m walked along a path of {:.2f} m, {} "
                        "transitions, {:.1f} ms",
                        shownText(path), report.frames, report.durationSeconds, report.motionLengthMetres,
                        report.pathLengthMetres, report.transitions, report.totalMilliseconds));
}

/// Says how each walker's plan ended; the exit code.
int tell(const PlanArguments& arguments, const Plan& plan) {
  const WalkFiles walks(arguments.walkPath);
  const std::vector<const Plan*> all = allOf(plan);
  std::FILE* const stream = isStandardOutput(arguments.reportPath) ? stderr : stdout;
  int exitCode = kDone;
  for (std::size_t walker = 0; walker < all.size(); ++walker) {
    const PlanReport& report = all[walker]->report;
    const std::string who = all.size() > 1 ? fmt::format("walker {}: ", walker + 1) : "";
    if (!hasArrived(*all[walker])) {
      complain("stridegraph plan",
               fmt::format("{}{}: {}", who, planStatusName(report.status), report.explanation));
      exitCode = kRefused;
      continue;
    }
    if (arguments.isQuiet) continue;
    printWalk(stream, walks.pathOf(walker), report);
    if (!report.explanation.empty()) printLine(stderr, fmt::format("note: {}{}", who, report.explanation));
  }
  return exitCode;
}

/// Ends a plan that could not be made or written.
int giveUp(const PlanArguments& arguments, const Error& error, Warnings notes) {
  noteFileOfBefore(arguments.walkPath, "a walk of this plan", notes);
  noteFileOfBefore(arguments.reportPath, "the report of this plan", notes);
  printNotes(notes, arguments.isQuiet);
  complain("stridegraph plan", describe(error));
  return kWrongUse;
}

int runPlan(const PlanArguments& arguments) {
  if (auto checked = checkOutputs(inputsOf(arguments), outputsOf(arguments, 1)); !checked) {
    complain("stridegraph plan", describe(checked.error()));
    return kWrongUse;
  }
  Warnings notes = uselessOptions(arguments);
  const Result<Planned> planned = makePlan(arguments, notes);
  if (!planned) return giveUp(arguments, planned.error(), std::move(notes));
  WalkFiles(arguments.walkPath).noteOld(allOf(planned->plan), notes);
  if (auto written = writeFiles(arguments, *planned, notes); !written)
    return giveUp(arguments, written.error(), std::move(notes));
  printNotes(notes, arguments.isQuiet);
  return tell(arguments, planned->plan);
}

}  // namespace

void addPlanCommand(CLI::App& program, Job& job) {
  CLI::App& command =
      *program.add_subcommand("plan", "Plan a walk through a scene and write it as BVH or GLB");
  auto arguments = std::make_shared<PlanArguments>();
  addPlanOptions(command, arguments);
  command.callback([arguments, &job] { job = [arguments] { return runPlan(*arguments); }; });
}

}  // namespace stridegraph::tools
