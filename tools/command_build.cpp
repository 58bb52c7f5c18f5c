#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <optional>

#include "base/utf8.h"
#include "build_report.h"
#include "clip_files.h"
#include "commands.h"
#include "graph/library_builder.h"
#include "graph/sgraph_file.h"
#include "library_file.h"
#include "notes.h"
#include "program/arguments.h"
#include "program/file_identity.h"
#include "program/output_files.h"
#include "program/progress.h"
#include "program/shown_text.h"

namespace stridegraph::tools {
namespace {

constexpr NumberRange kUnitsRange{1e-9, 1e6, "metres"};
/// Share of the work that reading the clips is taken for.
constexpr double kReadingShare = 0.1;

struct BuildArguments {
  std::vector<std::string> clipPaths;
  std::string libraryPath;
  std::string appendPath;
  std::string reportPath;
  std::string license;
  std::string up = "auto";
  BvhReadParams read;
  LibraryParams params;
  bool isQuiet = false;
};

/// How many of a file's units are in a metre; nothing for "auto".
std::optional<double> unitsFrom(const std::string& text) {
  if (text == "auto") return std::nullopt;
  if (text == "m") return 1.0;
  if (text == "cm") return 100.0;
  if (text == "in") return 1.0 / 0.0254;
  const Result<double> metresPerUnit = parseNumber(text, kUnitsRange);
  if (metresPerUnit) return 1.0 / *metresPerUnit;
  throw CLI::ValidationError(
      "--units", fmt::format("found {}, expected auto, m, cm, in or metres per unit, {} to {}",
                             quotedText(text), plainNumber(kUnitsRange.low), plainNumber(kUnitsRange.high)));
}

std::vector<NamedPath> outputsOf(const BuildArguments& arguments) {
  std::vector<NamedPath> outputs = {{"-o", arguments.libraryPath}};
  if (!arguments.reportPath.empty()) outputs.push_back({"--report", arguments.reportPath});
  return outputs;
}

/// The library that is appended to may be replaced by the new one: it is read whole before.
Result<void> checkPaths(const BuildArguments& arguments) {
  std::vector<NamedPath> clips;
  for (const std::string& path : arguments.clipPaths) clips.push_back({"a clip", path});
  if (auto checked = checkOutputs(clips, outputsOf(arguments)); !checked) return checked;
  if (arguments.appendPath.empty() || arguments.reportPath.empty()) return {};
  return checkOutputs({{"--append", arguments.appendPath}}, {{"--report", arguments.reportPath}});
}

std::string licenseOf(const BuildArguments& arguments, Warnings& notes) {
  if (!isUtf8(arguments.license))
    notes.push_back(
        {"found text that is not UTF-8, read it as Windows-1252", {"--license"}, WarningTopic::kText});
  return toUtf8(arguments.license);
}

Result<LibraryBuilder> startBuilder(const BuildArguments& arguments, Warnings& notes, Progress& progress) {
  const std::vector<std::string> paths = withoutRepeats(arguments.clipPaths, notes);
  auto clips =
      readClipFiles(paths, arguments.read, [&](double share) { progress.at(kReadingShare * share); });
  if (!clips) return fail(std::move(clips));
  const std::string license = licenseOf(arguments, notes);
  if (arguments.appendPath.empty())
    return LibraryBuilder::start(std::move(*clips), arguments.params, license);
  auto library = readLibraryFile(arguments.appendPath);
  if (!library) return fail(std::move(library));
  return LibraryBuilder::append(std::move(*library), std::move(*clips), license);
}

void printSummary(const BuildArguments& arguments, const BuildReport& report, const MotionLibrary& library) {
  if (arguments.isQuiet) return;
  const auto surviving = std::count_if(report.clips.begin(), report.clips.end(),
                                       [](const ClipFate& clip) { return clip.survivingFrames > 0; });
  printLine(
      isStandardOutput(arguments.libraryPath) || isStandardOutput(arguments.reportPath) ? stderr : stdout,
      fmt::format("{}: {} of {} clips, {:.0f} % of {} frames; {} nodes, {} clip pieces, {} transitions "
                  "({}, {}, {} before pruning)",
                  shownText(arguments.libraryPath), surviving, report.clips.size(),
                  100.0 * report.survivingShare, library.frames.frameCount(), report.nodes, report.clipPieces,
                  report.transitions, report.nodesBeforePruning, report.clipPiecesBeforePruning,
                  report.transitionsBeforePruning));
}

int refuse(const BuildArguments& arguments, const Error& error, const Warnings& notes, int code) {
  printNotes(notes, arguments.isQuiet);
  complain("stridegraph build", describe(error));
  return code;
}

/// Ends a build that came to no library, or could not write it.
int giveUp(const BuildArguments& arguments, const Error& error, Warnings notes) {
  noteFileOfBefore(arguments.libraryPath, "a library of this build", notes);
  noteFileOfBefore(arguments.reportPath, "the report of this build", notes);
  return refuse(arguments, error, notes, kWrongUse);
}

int writeResults(const BuildArguments& arguments, const BuildReport& report,
                 const Result<MotionLibrary>& library, Warnings notes) {
  if (!library) noteFileOfBefore(arguments.libraryPath, "a library of this build", notes);
  BuildOutcome outcome;
  outcome.library = library ? &*library : nullptr;
  outcome.error = library ? nullptr : &library.error();
  outcome.notes = notes;
  OutputFiles files;
  Result<void> written;
  if (library) written = files.add(arguments.libraryPath, writeSgraph(*library));
  if (written && !arguments.reportPath.empty())
    written = files.add(arguments.reportPath, buildReportText(report, outcome));
  if (written) written = files.commit();
  if (!written) return giveUp(arguments, written.error(), notes);
  if (!library) {
    notes.insert(notes.end(), report.warnings.begin(), report.warnings.end());
    return refuse(arguments, library.error(), notes, kRefused);
  }
  printNotes(notes, arguments.isQuiet);
  printNotes(report.warnings, arguments.isQuiet);
  printSummary(arguments, report, *library);
  return kDone;
}

int runBuild(const BuildArguments& arguments) {
  if (auto checked = checkPaths(arguments); !checked)
    return refuse(arguments, checked.error(), {}, kWrongUse);
  Warnings notes;
  std::optional<Progress> progress;
  progress.emplace("building", arguments.isQuiet);
  auto builder = startBuilder(arguments, notes, *progress);
  if (builder) {
    while (builder->step()) progress->at(kReadingShare + (1.0 - kReadingShare) * builder->progress());
  }
  progress.reset();
  if (!builder) return giveUp(arguments, builder.error(), std::move(notes));
  const Result<MotionLibrary> library = builder->finish();
  return writeResults(arguments, builder->report(), library, std::move(notes));
}

/// Settings of a new library, which a library that is appended to has already.
void addSettings(CLI::App& command, BuildArguments& arguments, CLI::Option* append) {
  LibraryParams& params = arguments.params;
  addNumber(command, "--threshold", params.thresholdMetres, {0.0, 10.0, "metres", true},
            "Largest distance along a transition")
      ->excludes(append);
  addWhole(command, "--transition-frames", params.transitionFrames, {2, 120, "frames"},
           "Length of a transition")
      ->excludes(append);
  addWhole(command, "--neighbours", params.neighbourFrames, {0, 100, "frames"},
           "Keep only the best of the transitions within so many of each other")
      ->excludes(append);
  addNumber(command, "--span-ratio", params.largestSpanRatio, {1.0, 2.0, "times"},
            "How much longer one side of a transition may be than the other")
      ->excludes(append);
  addWhole(command, "--most-transitions", params.mostTransitions, {1000, 1'000'000'000, "transitions"},
           "Of a library with more keep so many, spread over all that its clips show")
      ->excludes(append);
  addNumber(command, "--fps", params.framesPerSecond, {1.0, 240.0, "frames a second"}, "Rate of the library")
      ->excludes(append);
  command.add_flag("--mirror", params.mirror, "Also every clip with left and right swapped")
      ->excludes(append);
}

}  // namespace

void addBuildCommand(CLI::App& program, Job& job) {
  CLI::App& command = *program.add_subcommand("build", "Build a library from motion capture clips");
  auto arguments = std::make_shared<BuildArguments>();
  command.add_option("clips", arguments->clipPaths, "Clips (BVH); a clip given twice is taken once")
      ->required()
      ->type_name("FILE");
  addPath(command, "-o,--output", arguments->libraryPath, "FILE", "Library to write (.sgraph)")->required();
  CLI::Option* append =
      addPath(command, "--append", arguments->appendPath, "FILE",
              "Go on from this library (.sgraph), with its settings; only new frames are compared");
  addSettings(command, *arguments, append);
  addText(
      command, "--units",
      [arguments](const std::string& text) { arguments->read.unitsPerMetre = unitsFrom(text); },
      "Length unit of the clips: auto, m, cm, in or metres per unit, 0.000000001 to 1000000")
      ->type_name("UNIT")
      ->default_str("auto");
  addChoice(command, "--up", arguments->up, {"auto", "y", "z"}, "Axis of the clips that points up");
  command.add_option("--license", arguments->license, "A line on origin and terms, kept in the library")
      ->type_name("TEXT");
  addPath(command, "--report", arguments->reportPath, "FILE", "Write the report (JSON)");
  addQuiet(command, arguments->isQuiet);
  command.callback([arguments, &job] {
    if (arguments->up != "auto") arguments->read.up = arguments->up == "y" ? UpAxis::kY : UpAxis::kZ;
    job = [arguments] { return runBuild(*arguments); };
  });
}

}  // namespace stridegraph::tools
