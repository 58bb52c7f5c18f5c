#include <fmt/format.h>

#include <filesystem>
#include <functional>

#include "gait_fit/held_out.h"
#include "gait_fit/pictures.h"
#include "gait_fit/retarget.h"
#include "gait_fit/table.h"
#include "motion/bvh_limits.h"
#include "motion/bvh_reader.h"
#include "program/arguments.h"
#include "program/file_identity.h"
#include "program/files.h"
#include "program/output_files.h"
#include "program/run_program.h"
#include "program/shown_text.h"

namespace stridegraph::tools {
namespace {

using namespace gait_fit;

struct FitArguments {
  std::vector<std::string> walkPaths;
  std::vector<std::string> jogPaths;
  std::vector<std::string> origin;
  std::string sourcePath;
  std::string jsonPath;
  std::string heldOutFolder;
  FitParams walk = fitParamsFor(Gait::kWalk);
  FitParams jog = fitParamsFor(Gait::kJog);
  double walkReach = 0.996;  ///< Captured legs are hardly ever straighter in stance.
  double jogReach = 0.988;
};

/// Everything measured on one gait's clips.
struct Measured {
  GaitFit fit;
  SideLaws laws;
  GaitTable table;
};

int refuse(const Error& error) {
  complain("gait_fit", describe(error));
  const bool cannotFit = error.code == ErrorCode::kClipTooShort || error.code == ErrorCode::kInvalidArgument;
  return cannotFit ? kRefused : kWrongUse;
}

Result<std::vector<Clip>> readClips(const std::vector<std::string>& paths, Gait gait) {
  std::vector<Clip> clips;
  Skeleton skeleton;
  for (const std::string& path : paths) {
    auto bytes = readFile(path, kMostBvhBytes);
    if (!bytes) return fail(std::move(bytes));
    auto document = readBvh(*bytes, shownText(path));
    if (!document) return fail(std::move(document));
    if (clips.empty()) skeleton = document->skeleton;
    const std::string difference = differenceBetween(skeleton, document->skeleton);
    if (!difference.empty()) return fail(ErrorCode::kSkeletonMismatch, difference, {shownText(path)});
    document->clip.name = shownText(std::filesystem::path(path).stem().string());
    clips.push_back(std::move(document->clip));
  }
  return onGaitBody(skeleton, clips, gait);
}

Result<Measured> measure(std::vector<Clip> clips, const FitParams& params, double reach) {
  auto fit = fitGait(std::move(clips), params);
  if (!fit && fit.error().place.file.empty())
    fit.error().place.file = params.gait == Gait::kWalk ? "--walk" : "--jog";
  if (!fit) return fail(std::move(fit));
  auto laws = measureSideLaws(*fit);
  if (!laws) return fail(std::move(laws));
  auto table = tableOf(fit->series, *laws, reach);
  if (!table) return fail(std::move(table));
  return Measured{std::move(*fit), *laws, *table};
}

Result<void> writeHeldOut(const std::string& folder, const Measured& walk, const Measured& jog) {
  if (auto made = makeFolder(folder); !made) return made;
  OutputFiles files;
  std::vector<NamedFigures> figures;
  for (const auto& [name, measured] : {std::pair{"walk", &walk}, std::pair{"jog", &jog}}) {
    auto found = measureHeldOut(measured->fit);
    if (!found) return fail(std::move(found));
    figures.push_back({name, std::move(*found)});
    for (const Picture& picture : picturesOf(measured->fit, measured->table, name)) {
      if (auto added = files.add(folder + "/" + picture.name + ".svg", picture.svg); !added) return added;
    }
  }
  const std::string markdown = toMarkdown(figures);
  print(stdout, markdown);
  if (auto added = files.add(folder + "/held_out.md", markdown); !added) return added;
  if (auto added = files.add(folder + "/held_out.json", toJson(figures)); !added) return added;
  return files.commit();
}

Result<void> writeTables(const FitArguments& arguments, const FittedTables& tables) {
  OutputFiles files;
  Result<void> added;
  if (!arguments.sourcePath.empty()) added = files.add(arguments.sourcePath, toSource(tables));
  if (added && !arguments.jsonPath.empty()) added = files.add(arguments.jsonPath, toJson(tables));
  return added ? files.commit() : added;
}

Result<void> checkPaths(const FitArguments& arguments) {
  std::vector<NamedPath> inputs;
  for (const std::string& path : arguments.walkPaths) inputs.push_back({"--walk", path});
  for (const std::string& path : arguments.jogPaths) inputs.push_back({"--jog", path});
  std::vector<NamedPath> outputs;
  if (!arguments.sourcePath.empty()) outputs.push_back({"--source", arguments.sourcePath});
  if (!arguments.jsonPath.empty()) outputs.push_back({"--json", arguments.jsonPath});
  return checkOutputs(inputs, outputs);
}

std::vector<std::string> shownOrigin(const FitArguments& arguments) {
  std::vector<std::string> sentences;
  for (const std::string& sentence : arguments.origin) sentences.push_back(shownText(sentence));
  return sentences;
}

int run(const FitArguments& arguments) {
  if (auto checked = checkPaths(arguments); !checked) return refuse(checked.error());
  auto walks = readClips(arguments.walkPaths, Gait::kWalk);
  if (!walks) return refuse(walks.error());
  auto jogs = readClips(arguments.jogPaths, Gait::kJog);
  if (!jogs) return refuse(jogs.error());
  auto standing = measureStanding(*walks);
  if (!standing) return refuse(standing.error());
  auto walk = measure(std::move(*walks), arguments.walk, arguments.walkReach);
  if (!walk) return refuse(walk.error());
  auto jog = measure(std::move(*jogs), arguments.jog, arguments.jogReach);
  if (!jog) return refuse(jog.error());
  const auto written = writeTables(arguments, {walk->table, jog->table, *standing, shownOrigin(arguments)});
  if (!written) return refuse(written.error());
  if (arguments.heldOutFolder.empty()) return kDone;
  const auto evaluated = writeHeldOut(arguments.heldOutFolder, *walk, *jog);
  return evaluated ? kDone : refuse(evaluated.error());
}

/// A number for both gaits, within a range.
struct SharedOption {
  std::string name;
  std::function<double&(FitParams&)> member;
  NumberRange range;
  std::string help;
};

void addShared(CLI::App& program, FitArguments& arguments, const SharedOption& option) {
  const auto set = [&arguments, option](const std::string& text) {
    const double value = numberOrThrow(option.name, text, option.range);
    option.member(arguments.walk) = option.member(arguments.jog) = value;
  };
  addText(program, option.name, set, option.help + ": " + describe(option.range))
      ->type_name("X")
      ->default_str(plainNumber(option.member(arguments.walk)));
}

void addSharedOptions(CLI::App& program, FitArguments& arguments) {
  const std::vector<SharedOption> options = {
      {"--ridge",
       [](FitParams& p) -> double& { return p.series.ridge; },
       {0.0, 1e6, "frames"},
       "Penalty on the main coefficients"},
      {"--rate-ridge",
       [](FitParams& p) -> double& { return p.series.rateRidge; },
       {0.0, 1e6, "frames"},
       "Penalty on those of rates of change and products"},
      {"--upper-offset-share",
       [](FitParams& p) -> double& { return p.series.upperOffsetShare; },
       {0.0, 1.0, ""},
       "Share of a clip's mean put down to the single take, above the pelvis"},
      {"--lower-offset-share",
       [](FitParams& p) -> double& { return p.series.lowerOffsetShare; },
       {0.0, 1.0, ""},
       "The same, pelvis and legs"},
      {"--stiffness",
       [](FitParams& p) -> double& { return p.phase.stiffness; },
       {1e-3, 1e6, ""},
       "Penalty on second differences of the phase"}};
  for (const SharedOption& option : options) addShared(program, arguments, option);
}

void addFiles(CLI::App& program, FitArguments& arguments) {
  program.add_option("--walk", arguments.walkPaths, "Walks (BVH), one of which begins or ends standing")
      ->required()
      ->type_name("FILE");
  program.add_option("--jog", arguments.jogPaths, "Jogs (BVH) of the same body")
      ->required()
      ->type_name("FILE");
  addPath(program, "--source", arguments.sourcePath, "FILE",
          "Write the tables as C++ (core/motion/gait_table.cpp)");
  addPath(program, "--json", arguments.jsonPath, "FILE", "Write the tables as JSON");
  program.add_option("--origin", arguments.origin, "Sentences on source and terms, kept in both")
      ->type_name("TEXT");
  addPath(program, "--held-out", arguments.heldOutFolder, "FOLDER",
          "Leave each clip out in turn and write figures and pictures here");
}

void addOptions(CLI::App& program, FitArguments& arguments) {
  addFiles(program, arguments);
  addNumber(program, "--walk-speed", arguments.walk.series.referenceSpeed, {0.0, 10.0, "m/s", true},
            "Speed that walks are described around");
  addNumber(program, "--jog-speed", arguments.jog.series.referenceSpeed, {0.0, 10.0, "m/s", true},
            "Speed that jogs are described around");
  addNumber(program, "--walk-reach", arguments.walkReach, {0.9, 1.0, "of its length"},
            "Longest leg in stance");
  addNumber(program, "--jog-reach", arguments.jogReach, {0.9, 1.0, "of its length"}, "The same for the jog");
  addSharedOptions(program, arguments);
}

}  // namespace
}  // namespace stridegraph::tools

int main(int argc, char** argv) {
  using namespace stridegraph::tools;
  CLI::App program{
      "Measures a gait model from captured walks and jogs, and how well it tells clips it has not seen.",
      "gait_fit"};
  FitArguments arguments;
  addOptions(program, arguments);
  Job job;
  program.callback([&] { job = [&] { return run(arguments); }; });
  return runProgram(program, argc, argv, job);
}
