#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/hash.h"
#include "commands.h"
#include "files.h"
#include "graph/library_builder.h"
#include "graph/sgraph_file.h"

namespace stridegraph::tools {
namespace {

struct BuildArguments {
  std::vector<std::string> clipPaths;
  std::string libraryPath;
  std::string appendPath;
  std::string reportPath;
  std::string license;
  std::string units = "auto";
  std::string up = "auto";
  LibraryParams params;
};

Result<BvhReadParams> readParams(const BuildArguments& arguments) {
  BvhReadParams params;
  if (arguments.up != "auto") params.up = arguments.up == "y" ? UpAxis::kY : UpAxis::kZ;
  if (arguments.units == "auto") return params;
  if (arguments.units == "m") params.unitsPerMetre = 1.0;
  if (arguments.units == "cm") params.unitsPerMetre = 100.0;
  if (arguments.units == "in") params.unitsPerMetre = 1.0 / 0.0254;
  if (params.unitsPerMetre) return params;
  double metresPerUnit = 0.0;
  if (!CLI::detail::lexical_cast(arguments.units, metresPerUnit) || metresPerUnit <= 0.0) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("--units: found {}, expected auto, m, cm, in or metres per unit above 0",
                            arguments.units));
  }
  params.unitsPerMetre = 1.0 / metresPerUnit;
  return params;
}

Result<std::vector<BvhDocument>> readClips(const BuildArguments& arguments) {
  auto params = readParams(arguments);
  if (!params) return fail(std::move(params));
  std::vector<BvhDocument> clips;
  for (const std::string& path : arguments.clipPaths) {
    auto text = readFile(path);
    if (!text) return fail(std::move(text));
    auto clip = readBvh(*text, path, *params);
    if (!clip) return fail(std::move(clip));
    clip->clip.name = std::filesystem::path(path).stem().string();
    clips.push_back(std::move(*clip));
  }
  return clips;
}

std::string toJson(const BuildReport& report, const MotionLibrary* library, const Error* error) {
  nlohmann::ordered_json json;
  json["status"] = error == nullptr ? "built" : std::string(errorCodeName(error->code));
  json["explanation"] = error == nullptr ? std::string() : describe(*error);
  json["frame_pairs"] = report.framePairs;
  json["before_pruning"] = {{"nodes", report.nodesBeforePruning},
                            {"clip_pieces", report.clipPiecesBeforePruning},
                            {"transitions", report.transitionsBeforePruning}};
  json["after_pruning"] = {
      {"nodes", report.nodes}, {"clip_pieces", report.clipPieces}, {"transitions", report.transitions}};
  json["transitions_before_thinning"] = report.transitionsBeforeThinning;
  json["surviving_share"] = report.survivingShare;
  for (const ClipFate& clip : report.clips) {
    json["clips"].push_back({{"name", clip.name},
                             {"frames", clip.frames},
                             {"transitions", clip.transitions},
                             {"surviving_frames", clip.survivingFrames},
                             {"reason", clip.reason}});
  }
  json["warnings"] = nlohmann::ordered_json::array();
  for (const Warning& warning : report.warnings) json["warnings"].push_back(describe(warning));
  if (library != nullptr) json["library_hash"] = hexDigits(library->hash);
  return json.dump(1) + "\n";
}

void printSummary(const BuildArguments& arguments, const BuildReport& report, const MotionLibrary& library) {
  for (const Warning& warning : report.warnings) fmt::print(stderr, "note: {}\n", describe(warning));
  fmt::print(
      "{}: {} of {} clips, {:.0f} % of {} frames; {} nodes, {} clip pieces, {} transitions ({}, {}, {} "
      "before pruning)\n",
      arguments.libraryPath,
      std::count_if(report.clips.begin(), report.clips.end(),
                    [](const ClipFate& clip) { return clip.survivingFrames > 0; }),
      report.clips.size(), 100.0 * report.survivingShare, library.frames.frameCount(), report.nodes,
      report.clipPieces, report.transitions, report.nodesBeforePruning, report.clipPiecesBeforePruning,
      report.transitionsBeforePruning);
}

int refuse(const Error& error, int code) {
  fmt::print(stderr, "stridegraph build: {}\n", describe(error));
  return code;
}

Result<LibraryBuilder> startBuilder(const BuildArguments& arguments) {
  auto clips = readClips(arguments);
  if (!clips) return fail(std::move(clips));
  if (arguments.appendPath.empty())
    return LibraryBuilder::start(std::move(*clips), arguments.params, arguments.license);
  const auto bytes = readFile(arguments.appendPath);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  auto library = readSgraph(bytesOf(*bytes));
  if (!library) return fail(library.error().code, library.error().message, {arguments.appendPath});
  return LibraryBuilder::append(std::move(*library), std::move(*clips), arguments.license);
}

int runBuild(const BuildArguments& arguments) {
  auto builder = startBuilder(arguments);
  if (!builder) return refuse(builder.error(), kWrongUse);
  while (builder->step()) {
  }
  auto library = builder->finish();
  const BuildReport& report = builder->report();
  if (!arguments.reportPath.empty()) {
    const auto written = writeFile(arguments.reportPath, toJson(report, library ? &*library : nullptr,
                                                                library ? nullptr : &library.error()));
    if (!written) return refuse(written.error(), kWrongUse);
  }
  if (!library) return refuse(library.error(), kRefused);
  const auto written = writeFile(arguments.libraryPath, writeSgraph(*library));
  if (!written) return refuse(written.error(), kWrongUse);
  printSummary(arguments, report, *library);
  return kDone;
}

}  // namespace

void addBuildCommand(CLI::App& program, int& exitCode) {
  CLI::App* command = program.add_subcommand("build", "Build a library from motion capture clips");
  auto arguments = std::make_shared<BuildArguments>();
  LibraryParams& params = arguments->params;
  command->add_option("clips", arguments->clipPaths, "Clips (BVH)")->required();
  command->add_option("-o,--output", arguments->libraryPath, "Library to write (.sgraph)")->required();
  CLI::Option* append = command->add_option(
      "--append", arguments->appendPath,
      "Go on from this library (.sgraph), with its settings; only new frames are compared");
  const auto setting = [&](const std::string& name, auto& value, const std::string& meaning) {
    command->add_option(name, value, meaning)->capture_default_str()->excludes(append);
  };
  setting("--threshold", params.thresholdMetres, "Largest distance along a transition, metres");
  setting("--transition-frames", params.transitionFrames, "Length of a transition");
  setting("--neighbours", params.neighbourFrames,
          "Keep only the best of the transitions within so many frames of each other");
  setting("--span-ratio", params.largestSpanRatio,
          "How many times longer one side of a transition may be than the other, 1 to 2");
  setting("--most-transitions", params.mostTransitions,
          "Of a library with more keep so many, 1000 or more, spread over all that its clips show");
  setting("--fps", params.framesPerSecond, "Frames a second of the library");
  command->add_option("--units", arguments->units, "auto, m, cm, in or metres per unit")
      ->capture_default_str();
  command->add_option("--up", arguments->up)->check(CLI::IsMember({"auto", "y", "z"}))->capture_default_str();
  command->add_flag("--mirror", params.mirror, "Also every clip with left and right swapped")
      ->excludes(append);
  command->add_option("--license", arguments->license, "A line on origin and terms, kept in the library");
  command->add_option("--report", arguments->reportPath, "Write the report (JSON)");
  command->callback([arguments, &exitCode] { exitCode = runBuild(*arguments); });
}

}  // namespace stridegraph::tools
