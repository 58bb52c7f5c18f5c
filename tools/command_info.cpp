#include <fmt/format.h>

#include <cstdio>

#include "base/hash.h"
#include "commands.h"
#include "library_file.h"
#include "notes.h"
#include "program/arguments.h"
#include "program/json_document.h"
#include "program/rounding.h"
#include "program/shown_text.h"

namespace stridegraph::tools {
namespace {

struct InfoArguments {
  std::string path;
  bool asJson = false;
};

Json toJson(const MotionLibrary& library) {
  Json json;
  json["library_hash"] = hexDigits(library.hash);
  json["license"] = library.license;
  json["joints"] = library.skeleton.size();
  json["units_per_metre"] = library.layout.unitsPerMetre;
  json["frames_per_second"] = library.frames.framesPerSecond;
  json["frames"] = library.frames.frameCount();
  json["facing_offset_deg"] = library.facingOffset.angle().degrees();
  json["threshold_m"] = library.params.thresholdMetres;
  json["transition_frames"] = library.params.transitionFrames;
  json["mirror"] = library.params.mirror;
  json["nodes"] = library.graph.nodes.size();
  json["clip_pieces"] = library.graph.clipPieceCount();
  json["transitions"] = library.graph.transitionCount();
  json["clips"] = Json::array();
  for (const LibraryClip& clip : library.clips) {
    json["clips"].push_back({{"name", clip.name},
                             {"first_frame", clip.firstFrame},
                             {"frames", clip.frameCount},
                             {"mirrored", clip.mirrored}});
  }
  json["notes"] = notesJson(library.notes);
  return json;
}

std::string textOf(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  return value.is_number_float() ? rounded(value.get<double>()) : value.dump();
}

void printText(const Json& json, const Warnings& notes) {
  for (const auto& [key, value] : json.items()) {
    if (!value.is_array()) printLine(stdout, fmt::format("{:18} {}", key, textOf(value)));
  }
  for (const auto& clip : json["clips"]) {
    printLine(stdout, fmt::format("  {:40} {:6} frames{}", shownText(clip["name"].get<std::string>()),
                                  clip["frames"].get<std::size_t>(),
                                  clip["mirrored"].get<bool>() ? ", mirrored" : ""));
  }
  for (const Warning& note : notes) printLine(stdout, fmt::format("note: {}", shownText(describe(note))));
}

int runInfo(const InfoArguments& arguments) {
  const auto library = readLibraryFile(arguments.path);
  if (!library) {
    complain("stridegraph info", describe(library.error()));
    return kWrongUse;
  }
  const Json json = toJson(*library);
  if (arguments.asJson)
    print(stdout, documentText(json));
  else
    printText(json, library->notes);
  return kDone;
}

}  // namespace

void addInfoCommand(CLI::App& program, Job& job) {
  CLI::App& command = *program.add_subcommand("info", "Say what is in a library");
  auto arguments = std::make_shared<InfoArguments>();
  addPath(command, "library", arguments->path, "FILE", "Library (.sgraph)")->required();
  command.add_flag("--json", arguments->asJson, "As JSON, with all digits");
  command.callback([arguments, &job] { job = [arguments] { return runInfo(*arguments); }; });
}

}  // namespace stridegraph::tools
