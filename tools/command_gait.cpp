#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "commands.h"
#include "files.h"
#include "motion/bvh_writer.h"
#include "motion/gait_library.h"
#include "motion/gait_skeleton.h"

namespace stridegraph::tools {
namespace {

int cannotWrite(const Error& error) {
  fmt::print(stderr, "stridegraph gait: {}\n", describe(error));
  return kWrongUse;
}

/// Writes the clips and where they come from into a folder, which is made.
int writeClips(const std::string& folder, const std::vector<Clip>& clips) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) {
    fmt::print(stderr, "stridegraph gait: {}: cannot be made: {}\n", folder, failed.message());
    return kWrongUse;
  }
  std::size_t frames = 0;
  for (const Clip& clip : clips) {
    const auto written =
        writeFile(folder + "/" + clip.name + ".bvh", writeBvh(gaitSkeleton(), gaitBvhLayout(), clip));
    if (!written) return cannotWrite(written.error());
    frames += clip.frameCount();
  }
  const auto written = writeFile(folder + "/ORIGIN.txt", std::string(kGaitClipsLicense) + "\n");
  if (!written) return cannotWrite(written.error());
  fmt::print("{}: {} clips, {} frames\n", folder, clips.size(), frames);
  return kDone;
}

int runGait(const std::string& folder) {
  const int code = writeClips(folder, defaultGaitClips());
  return code == kDone ? writeClips(folder + "/thesis_pair", thesisGaitPair()) : code;
}

}  // namespace

void addGaitCommand(CLI::App& program, int& exitCode) {
  CLI::App* command =
      program.add_subcommand("gait",
                             "Write the synthesised default clips as BVH, where they come from, and in\n"
                             "the sub-folder thesis_pair the two jogs that the thesis used");
  auto folder = std::make_shared<std::string>();
  command->add_option("-o,--output", *folder, "Folder to write to")->required();
  command->callback([folder, &exitCode] { exitCode = runGait(*folder); });
}

}  // namespace stridegraph::tools
