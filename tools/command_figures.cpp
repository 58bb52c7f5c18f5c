#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "commands.h"
#include "figures/figure.h"
#include "files.h"
#include "graph/sgraph_file.h"
#include "scene_folder.h"

namespace stridegraph::tools {
namespace {

struct FiguresArguments {
  std::string folder;
  std::string graphPath = "build/library/default.sgraph";
  std::string scenesFolder = "public/scenes";
  std::vector<std::string> folders;
};

Result<figures::FigureInputs> readInputs(const FiguresArguments& arguments) {
  auto text = readFile(arguments.graphPath);
  if (!text) return fail(std::move(text));
  auto library = readSgraph(bytesOf(*text));
  if (!library) {
    library.error().place.file = arguments.graphPath;
    return fail(std::move(library));
  }
  auto files = readSceneFolder(arguments.scenesFolder);
  if (!files) return fail(std::move(files));
  std::vector<Scene> scenes;
  for (SceneFile& file : *files) scenes.push_back(std::move(file.scene));
  auto shared = std::make_shared<const MotionLibrary>(std::move(*library));
  return figures::FigureInputs{std::make_shared<const WalkPlanner>(std::move(shared)), std::move(scenes)};
}

/// What lies in a folder within the one that is written to.
Result<figures::FigureFolder> lookInto(const FiguresArguments& arguments, const std::string& name) {
  figures::FigureFolder folder{name, false, {}, {}};
  const std::filesystem::path place = std::filesystem::path(arguments.folder) / name;
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator(place, failed)) {
    const std::filesystem::path& path = entry.path();
    if (path.filename() == "index.html") folder.hasIndex = true;
    if (path.extension() == ".svg") folder.pictures.push_back(path.stem().string());
    if (path.extension() != ".md") continue;
    auto text = readFile(path.string());
    if (!text) return fail(std::move(text));
    folder.table = std::move(*text);
  }
  if (failed)
    return fail(ErrorCode::kFile,
                fmt::format("{}: found {}, expected a folder of pictures", place.string(), failed.message()));
  std::sort(folder.pictures.begin(), folder.pictures.end());
  return folder;
}

Result<std::size_t> writeFigures(const FiguresArguments& arguments) {
  auto inputs = readInputs(arguments);
  if (!inputs) return fail(std::move(inputs));
  if (auto made = makeFolder(arguments.folder); !made) return fail(std::move(made));
  const std::vector<figures::FigureSection> sections = figures::makeFigures(*inputs);
  std::size_t count = 0;
  for (const figures::FigureSection& section : sections) {
    for (const figures::Figure& figure : section.figures) {
      auto written = writeFile(arguments.folder + "/" + figure.name + ".svg", figure.svg.finish());
      if (!written) return fail(std::move(written));
      ++count;
    }
  }
  std::vector<figures::FigureFolder> folders;
  for (const std::string& name : arguments.folders) {
    auto folder = lookInto(arguments, name);
    if (!folder) return fail(std::move(folder));
    folders.push_back(std::move(*folder));
  }
  const std::string about = fmt::format("Made by stridegraph figures from {}: {} clips, {} frames. {}",
                                        arguments.graphPath, inputs->library().clips.size(),
                                        inputs->library().frames.frameCount(), inputs->library().license);
  auto written = writeFile(arguments.folder + "/index.html", figures::indexPage(sections, folders, about));
  if (!written) return fail(std::move(written));
  return count;
}

int runFigures(const FiguresArguments& arguments) {
  const Result<std::size_t> written = writeFigures(arguments);
  if (!written) {
    fmt::print(stderr, "stridegraph figures: {}\n", describe(written.error()));
    return kWrongUse;
  }
  fmt::print("{}/index.html: {} pictures\n", arguments.folder, *written);
  return kDone;
}

}  // namespace

void addFiguresCommand(CLI::App& program, int& exitCode) {
  CLI::App* command = program.add_subcommand("figures", "Draw every stage, from clips to walks, as SVG");
  auto arguments = std::make_shared<FiguresArguments>();
  command->add_option("-o,--output", arguments->folder, "Folder to write to")->required();
  command->add_option("--graph", arguments->graphPath, "Library (.sgraph)")->capture_default_str();
  command->add_option("--scenes", arguments->scenesFolder, "Folder of scenes (JSON)")->capture_default_str();
  command->add_option("--folder", arguments->folders,
                      "A folder within the output folder whose pictures the page shows, too");
  command->callback([arguments, &exitCode] { exitCode = runFigures(*arguments); });
}

}  // namespace stridegraph::tools
