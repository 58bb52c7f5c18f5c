#include <fmt/format.h>

#include <cstdio>

#include "commands.h"
#include "motion/bvh_writer.h"
#include "motion/gait_library.h"
#include "motion/gait_skeleton.h"
#include "program/arguments.h"
#include "program/output_files.h"
#include "program/shown_text.h"

namespace stridegraph::tools {
namespace {

struct GaitArguments {
  std::string folder;
  bool isQuiet = false;
};

/// Writes the clips and where they come from into a folder, which is made.
Result<void> writeClips(const std::string& folder, const std::vector<Clip>& clips, bool isQuiet) {
  if (auto made = makeFolder(folder); !made) return made;
  OutputFiles files;
  std::size_t frames = 0;
  for (const Clip& clip : clips) {
    auto added =
        files.add(folder + "/" + clip.name + ".bvh", writeBvh(gaitSkeleton(), gaitBvhLayout(), clip));
    if (!added) return added;
    frames += clip.frameCount();
  }
  if (auto added = files.add(folder + "/ORIGIN.txt", std::string(kGaitClipsLicense) + "\n"); !added)
    return added;
  if (auto written = files.commit(); !written) return written;
  if (!isQuiet)
    printLine(stdout, fmt::format("{}: {} clips, {} frames", shownText(folder), clips.size(), frames));
  return {};
}

int runGait(const GaitArguments& arguments) {
  Result<void> written = writeClips(arguments.folder, defaultGaitClips(), arguments.isQuiet);
  if (written) written = writeClips(arguments.folder + "/thesis_pair", thesisGaitPair(), arguments.isQuiet);
  if (written) return kDone;
  complain("stridegraph gait", describe(written.error()));
  return kWrongUse;
}

}  // namespace

void addGaitCommand(CLI::App& program, Job& job) {
  CLI::App& command =
      *program.add_subcommand("gait",
                              "Write the synthesised default clips as BVH, where they come from, and "
                              "in\nthe sub-folder thesis_pair the two jogs that the thesis used");
  auto arguments = std::make_shared<GaitArguments>();
  addPath(command, "-o,--output", arguments->folder, "FOLDER",
          "Where to write to; made where it is not there")
      ->required();
  addQuiet(command, arguments->isQuiet);
  command.callback([arguments, &job] { job = [arguments] { return runGait(*arguments); }; });
}

}  // namespace stridegraph::tools
