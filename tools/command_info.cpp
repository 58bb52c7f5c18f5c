#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/hash.h"
#include "commands.h"
#include "files.h"
#include "graph/sgraph_file.h"

namespace stridegraph::tools {
namespace {

nlohmann::ordered_json toJson(const MotionLibrary& library) {
  nlohmann::ordered_json json;
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
  json["clips"] = nlohmann::ordered_json::array();
  for (const LibraryClip& clip : library.clips) {
    json["clips"].push_back({{"name", clip.name},
                             {"first_frame", clip.firstFrame},
                             {"frames", clip.frameCount},
                             {"mirrored", clip.mirrored}});
  }
  return json;
}

void printText(const nlohmann::ordered_json& json) {
  for (const auto& [key, value] : json.items()) {
    if (!value.is_array())
      fmt::print("{:18} {}\n", key, value.is_string() ? value.get<std::string>() : value.dump());
  }
  for (const auto& clip : json["clips"]) {
    fmt::print("  {:40} {:6} frames{}\n", clip["name"].get<std::string>(), clip["frames"].get<std::size_t>(),
               clip["mirrored"].get<bool>() ? ", mirrored" : "");
  }
}

int runInfo(const std::string& path, bool asJson) {
  const auto text = readFile(path);
  if (!text) {
    fmt::print(stderr, "stridegraph info: {}\n", describe(text.error()));
    return kWrongUse;
  }
  const auto library = readSgraph(bytesOf(*text));
  if (!library) {
    fmt::print(stderr, "stridegraph info: {}: {}\n", path, describe(library.error()));
    return kWrongUse;
  }
  const nlohmann::ordered_json json = toJson(*library);
  if (asJson) {
    fmt::print("{}\n", json.dump(1));
  } else {
    printText(json);
  }
  return kDone;
}

}  // namespace

void addInfoCommand(CLI::App& program, int& exitCode) {
  CLI::App* command = program.add_subcommand("info", "Say what is in a library");
  auto path = std::make_shared<std::string>();
  auto asJson = std::make_shared<bool>(false);
  command->add_option("library", *path, "Library (.sgraph)")->required();
  command->add_flag("--json", *asJson, "As JSON");
  command->callback([path, asJson, &exitCode] { exitCode = runInfo(*path, *asJson); });
}

}  // namespace stridegraph::tools
