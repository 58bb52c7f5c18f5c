#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "base/utf8.h"
#include "commands.h"
#include "figures/make_figures.h"
#include "library_file.h"
#include "notes.h"
#include "program/arguments.h"
#include "program/file_identity.h"
#include "program/files.h"
#include "program/output_files.h"
#include "program/progress.h"
#include "program/shown_text.h"
#include "scene_folder.h"

namespace stridegraph::tools {
namespace {

struct FiguresArguments {
  std::string folder;
  std::string graphPath = "build/library/default.sgraph";
  std::string scenesFolder = "public/scenes";
  std::vector<std::string> folders;
  bool isQuiet = false;
};

/// All that is drawn, and what to say of it.
struct Drawn {
  std::vector<figures::FigureSection> sections;
  std::string about;
};

Result<Drawn> drawFigures(const FiguresArguments& arguments) {
  auto library = readLibraryFile(arguments.graphPath);
  if (!library) return fail(std::move(library));
  Warnings notes;
  auto files = readSceneFolder(arguments.scenesFolder, &notes);
  if (!files) return fail(std::move(files));
  printNotes(notes, arguments.isQuiet);
  std::vector<Scene> scenes;
  for (SceneFile& file : *files) scenes.push_back(std::move(file.scene));
  auto shared = std::make_shared<const MotionLibrary>(std::move(*library));
  const figures::FigureInputs inputs{std::make_shared<const WalkPlanner>(shared), std::move(scenes)};
  Progress progress("drawing", arguments.isQuiet);
  return Drawn{figures::makeFigures(inputs, [&](double share) { progress.at(share); }),
               fmt::format("Made by stridegraph figures from {}: {} clips, {} frames. {}",
                           shownText(arguments.graphPath), shared->clips.size(), shared->frames.frameCount(),
                           shownText(shared->license))};
}

/// What lies in a folder within the one that is written to.
Result<figures::FigureFolder> lookInto(const FiguresArguments& arguments, const std::string& name) {
  figures::FigureFolder folder{shownText(name), false, {}, {}};
  const std::filesystem::path place = std::filesystem::path(arguments.folder) / name;
  std::error_code wrong;
  for (std::filesystem::directory_iterator entry(place, wrong), end; !wrong && entry != end;
       entry.increment(wrong)) {
    const std::filesystem::path& path = entry->path();
    if (path.filename() == "index.html") folder.hasIndex = true;
    if (path.extension() == ".svg") folder.pictures.push_back(shownText(path.stem().string()));
    if (path.extension() != ".md") continue;
    auto text = readFile(path.string(), kMostReportBytes);
    if (!text) return fail(std::move(text));
    folder.table = toUtf8(*text);
  }
  if (wrong)
    return fail(ErrorCode::kFile, fmt::format("{}: found {}, expected a folder of pictures",
                                              shownText(place.string()), wrong.message()));
  std::sort(folder.pictures.begin(), folder.pictures.end());
  return folder;
}

Result<std::vector<figures::FigureFolder>> lookIntoAll(const FiguresArguments& arguments) {
  std::vector<figures::FigureFolder> folders;
  for (const std::string& name : arguments.folders) {
    auto folder = lookInto(arguments, name);
    if (!folder) return fail(std::move(folder));
    folders.push_back(std::move(*folder));
  }
  return folders;
}

/// Adds a file of the folder, unless it is the library that is drawn.
Result<void> addFile(OutputFiles& files, const FiguresArguments& arguments, const std::string& name,
                     std::string_view content) {
  const std::string path = arguments.folder + "/" + name;
  if (auto checked = checkOutputs({{"--graph", arguments.graphPath}}, {{"a picture", path}}); !checked)
    return checked;
  return files.add(path, content);
}

Result<std::size_t> writeFigures(const FiguresArguments& arguments) {
  if (auto made = makeFolder(arguments.folder); !made) return fail(std::move(made));
  auto folders = lookIntoAll(arguments);
  if (!folders) return fail(std::move(folders));
  auto drawn = drawFigures(arguments);
  if (!drawn) return fail(std::move(drawn));
  OutputFiles files;
  std::size_t count = 0;
  for (const figures::FigureSection& section : drawn->sections) {
    for (const figures::Figure& figure : section.figures) {
      auto added = addFile(files, arguments, figure.name + ".svg", figure.svg.finish());
      if (!added) return fail(std::move(added));
      ++count;
    }
  }
  auto added =
      addFile(files, arguments, "index.html", figures::indexPage(drawn->sections, *folders, drawn->about));
  if (added) added = files.commit();
  if (!added) return fail(std::move(added));
  return count;
}

int runFigures(const FiguresArguments& arguments) {
  const Result<std::size_t> written = writeFigures(arguments);
  if (!written) {
    complain("stridegraph figures", describe(written.error()));
    return kWrongUse;
  }
  if (!arguments.isQuiet)
    printLine(stdout, fmt::format("{}/index.html: {} pictures", shownText(arguments.folder), *written));
  return kDone;
}

}  // namespace

void addFiguresCommand(CLI::App& program, Job& job) {
  CLI::App& command = *program.add_subcommand("figures", "Draw every stage, from clips to walks, as SVG");
  auto arguments = std::make_shared<FiguresArguments>();
  addPath(command, "-o,--output", arguments->folder, "FOLDER",
          "Where to write to; made where it is not there")
      ->required();
  addPath(command, "--graph", arguments->graphPath, "FILE", "Library (.sgraph)")->capture_default_str();
  addPath(command, "--scenes", arguments->scenesFolder, "FOLDER", "Scenes (JSON)")->capture_default_str();
  command
      .add_option("--folder", arguments->folders,
                  "A folder within the output folder whose pictures the page shows, too")
      ->type_name("NAME");
  addQuiet(command, arguments->isQuiet);
  command.callback([arguments, &job] { job = [arguments] { return runFigures(*arguments); }; });
}

}  // namespace stridegraph::tools
