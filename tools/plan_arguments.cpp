#include "plan_arguments.h"

#include "program/arguments.h"
#include "walk_files.h"

namespace stridegraph::tools {
namespace {

void addFiles(CLI::App& command, const std::shared_ptr<PlanArguments>& arguments) {
  addPath(command, "--graph", arguments->graphPath, "FILE", "Library (.sgraph)")->required();
  addPath(command, "--scene", arguments->scenePath, "FILE", "Scene (JSON)")->required();
  const auto takeWalk = [arguments](const std::string& path) {
    if (const std::string fault = WalkFiles::faultIn(path); !fault.empty())
      throw CLI::ValidationError("--output", fault);
    arguments->walkPath = path;
  };
  addText(command, "-o,--output", takeWalk,
          "Walk to write: .bvh, further walkers' as WALK_2.bvh, WALK_3.bvh ..., or .glb with all")
      ->required()
      ->type_name("FILE");
  addPath(command, "--report", arguments->reportPath, "FILE", "Write the report (JSON)");
}

void addBody(CLI::App& command, const std::shared_ptr<PlanArguments>& arguments) {
  PlanOptions& options = arguments->options;
  addText(
      command, "--seed",
      [arguments](const std::string& text) {
        arguments->options.seed = wholeOrThrow("--seed", text, kSeedRange);
      },
      "Instead of the scene's: " + describe(kSeedRange))
      ->type_name("N");
  constexpr NumberRange kRadius{0.05, 5.0, "metres"};
  addText(
      command, "--radius",
      [arguments, kRadius](const std::string& text) {
        arguments->options.radiusMetres = numberOrThrow("--radius", text, kRadius);
      },
      "Of the body's disc, instead of the scene's: " + describe(kRadius))
      ->type_name("X");
  addNumber(command, "--goal-radius", options.goalRadiusMetres, {0.01, 5.0, "metres"},
            "How near the goal the search has to come");
  command.add_flag_callback(
      "--moving-ends", [arguments] { arguments->options.standing = false; },
      "Begin and end in motion even where the library can stand");
  command.add_flag_callback(
      "--raw-feet", [arguments] { arguments->options.footCleanup = false; },
      "Leave feet as blended, to compare: no pins, no lifting");
}

void addSearch(CLI::App& command, const std::shared_ptr<PlanArguments>& arguments) {
  const std::vector<std::string> planners = {"prm", "rrt-connect"};
  addText(
      command, "--planner",
      [arguments, planners](const std::string& text) {
        arguments->options.planner = *plannerFromName(choiceOrThrow("--planner", text, planners));
        arguments->asksForPlanner = true;
      },
      "How the path is found: prm or rrt-connect")
      ->type_name("WORD")
      ->default_str("prm");
  const std::vector<std::string> searches = {"guided", "thesis", "thesis-checked"};
  addText(
      command, "--search",
      [arguments, searches](const std::string& text) {
        arguments->options.search = *searchFromName(choiceOrThrow("--search", text, searches));
      },
      "How the walk is found: guided, thesis or thesis-checked")
      ->type_name("WORD")
      ->default_str("guided");
  addNumber(command, "--budget-ms", arguments->options.budgetMilliseconds,
            {0.0, 86'400'000.0, "milliseconds"}, "Time for the motion search; 0 for no limit");
  addWhole(command, "--improve", arguments->options.improvementExpansions, {0, 1'000'000'000, "states"},
           "How many to look at beyond the first walk's for a better one; 20000 take 20 to 50 ms");
  constexpr NumberRange kUntil{1.0, 10.0, "times"};
  addText(
      command, "--until",
      [arguments, kUntil](const std::string& text) {
        arguments->options.enoughRatio = numberOrThrow("--until", text, kUntil);
      },
      "Improve no further once the walk is at most so much longer than a disc's way: " + describe(kUntil))
      ->type_name("X");
}

Warning useless(const std::string& option, std::string why) {
  return {std::move(why), {option}, WarningTopic::kOther};
}

}  // namespace

void addPlanOptions(CLI::App& command, const std::shared_ptr<PlanArguments>& arguments) {
  addFiles(command, arguments);
  addBody(command, arguments);
  addSearch(command, arguments);
  addQuiet(command, arguments->isQuiet);
}

Warnings uselessOptions(const PlanArguments& arguments) {
  const PlanOptions& options = arguments.options;
  const bool isGuided = options.search == SearchKind::kGuided;
  Warnings notes;
  if (options.enoughRatio && options.improvementExpansions == 0)
    notes.push_back(useless("--until", "has no effect without --improve"));
  if (options.improvementExpansions > 0 && !isGuided)
    notes.push_back(useless("--improve", "has no effect, since only --search guided finds better walks"));
  if (arguments.asksForPlanner && isGuided)
    notes.push_back(useless("--planner",
                            "hardly changes the walk, which --search guided finds without the path; "
                            "the report's path_length_m is that planner's"));
  return notes;
}

}  // namespace stridegraph::tools
