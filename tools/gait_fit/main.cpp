#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <functional>

#include "commands.h"
#include "files.h"
#include "gait_fit/held_out.h"
#include "gait_fit/pictures.h"
#include "gait_fit/retarget.h"
#include "gait_fit/table.h"
#include "motion/bvh_reader.h"

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
  fmt::print(stderr, "gait_fit: {}\n", describe(error));
  const bool cannotFit = error.code == ErrorCode::kClipTooShort || error.code == ErrorCode::kInvalidArgument;
  return cannotFit ? kRefused : kWrongUse;
}

Result<std::vector<Clip>> readClips(const std::vector<std::string>& paths, Gait gait) {
  std::vector<Clip> clips;
  Skeleton skeleton;
  for (const std::string& path : paths) {
    auto text = readFile(path);
    if (!text) return fail(std::move(text));
    auto document = readBvh(*text, path);
    if (!document) return fail(std::move(document));
    if (clips.empty()) skeleton = document->skeleton;
    const std::string difference = differenceBetween(skeleton, document->skeleton);
    if (!difference.empty()) return fail(ErrorCode::kSkeletonMismatch, difference, {path});
    document->clip.name = std::filesystem::path(path).stem().string();
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
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) return fail(ErrorCode::kFile, "cannot be made: " + failed.message(), {folder});
  std::vector<NamedFigures> figures;
  for (const auto& [name, measured] : {std::pair{"walk", &walk}, std::pair{"jog", &jog}}) {
    auto found = measureHeldOut(measured->fit);
    if (!found) return fail(std::move(found));
    figures.push_back({name, std::move(*found)});
    for (const Picture& picture : picturesOf(measured->fit, measured->table, name)) {
      auto written = writeFile(folder + "/" + picture.name + ".svg", picture.svg);
      if (!written) return written;
    }
  }
  const std::string markdown = toMarkdown(figures);
  fmt::print("{}", markdown);
  auto written = writeFile(folder + "/held_out.md", markdown);
  return written ? writeFile(folder + "/held_out.json", toJson(figures)) : written;
}

Result<void> writeTables(const FitArguments& arguments, const FittedTables& tables) {
  Result<void> written;
  if (!arguments.sourcePath.empty()) written = writeFile(arguments.sourcePath, toSource(tables));
  if (written && !arguments.jsonPath.empty()) written = writeFile(arguments.jsonPath, toJson(tables));
  return written;
}

int run(const FitArguments& arguments) {
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
  const auto written = writeTables(arguments, {walk->table, jog->table, *standing, arguments.origin});
  if (!written) return refuse(written.error());
  if (arguments.heldOutFolder.empty()) return kDone;
  const auto evaluated = writeHeldOut(arguments.heldOutFolder, *walk, *jog);
  return evaluated ? kDone : refuse(evaluated.error());
}

/// A number for both gaits, within a range.
struct SharedOption {
  std::string name;
  std::function<double&(FitParams&)> member;
  double low;
  double high;
  std::string help;
};

void addShared(CLI::App& program, FitArguments& arguments, const SharedOption& option) {
  const auto set = [&arguments, member = option.member](const double& value) {
    member(arguments.walk) = member(arguments.jog) = value;
  };
  program.add_option_function<double>(option.name, set, option.help)
      ->check(CLI::Range(option.low, option.high))
      ->default_str(fmt::format("{:g}", option.member(arguments.walk)));
}

void addSharedOptions(CLI::App& program, FitArguments& arguments) {
  const std::vector<SharedOption> options = {
      {"--ridge", [](FitParams& p) -> double& { return p.series.ridge; }, 0.0, 1e6,
       "Penalty on the main coefficients, frames"},
      {"--rate-ridge", [](FitParams& p) -> double& { return p.series.rateRidge; }, 0.0, 1e6,
       "Penalty on those of rates of change and products, frames"},
      {"--upper-offset-share", [](FitParams& p) -> double& { return p.series.upperOffsetShare; }, 0.0, 1.0,
       "Share of a clip's mean put down to the single take, above the pelvis"},
      {"--lower-offset-share", [](FitParams& p) -> double& { return p.series.lowerOffsetShare; }, 0.0, 1.0,
       "The same, pelvis and legs"},
      {"--stiffness", [](FitParams& p) -> double& { return p.phase.stiffness; }, 1e-3, 1e6,
       "Penalty on second differences of the phase"}};
  for (const SharedOption& option : options) addShared(program, arguments, option);
}

void addOptions(CLI::App& program, FitArguments& arguments) {
  program.add_option("--walk", arguments.walkPaths, "Walks (BVH), one of which begins or ends standing")
      ->required();
  program.add_option("--jog", arguments.jogPaths, "Jogs (BVH) of the same body")->required();
  program.add_option("--source", arguments.sourcePath,
                     "Write the tables as C++ (core/motion/gait_table.cpp)");
  program.add_option("--json", arguments.jsonPath, "Write the tables as JSON");
  program.add_option("--origin", arguments.origin, "Sentences on source and terms, kept in both");
  program.add_option("--held-out", arguments.heldOutFolder,
                     "Leave each clip out in turn and write figures and pictures into this folder");
  program
      .add_option("--walk-speed", arguments.walk.series.referenceSpeed, "m/s that walks are described around")
      ->capture_default_str();
  program
      .add_option("--jog-speed", arguments.jog.series.referenceSpeed, "m/s that jogs are described around")
      ->capture_default_str();
  program.add_option("--walk-reach", arguments.walkReach, "Longest leg in stance, share of its length")
      ->check(CLI::Range(0.9, 1.0))
      ->capture_default_str();
  program.add_option("--jog-reach", arguments.jogReach, "The same for the jog")
      ->check(CLI::Range(0.9, 1.0))
      ->capture_default_str();
  addSharedOptions(program, arguments);
}

}  // namespace
}  // namespace stridegraph::tools

int main(int argc, char** argv) {
  using namespace stridegraph::tools;
  CLI::App program{
      "Measures a gait model from captured walks and jogs, and how well it tells clips it has not seen."};
  FitArguments arguments;
  addOptions(program, arguments);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? kDone : kWrongUse;
  }
  return run(arguments);
}
