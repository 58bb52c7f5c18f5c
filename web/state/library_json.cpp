#include "state/library_json.h"

#include <nlohmann/json.hpp>

#include "base/hash.h"

namespace stridegraph {

namespace {

/// Valid UTF-8 whatever names a file holds.
std::string dumped(const nlohmann::json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

nlohmann::json jsonOf(const Warnings& warnings) {
  nlohmann::json list = nlohmann::json::array();
  for (const Warning& warning : warnings) {
    list.push_back({{"topic", std::string(warningTopicName(warning.topic))},
                    {"message", warning.message},
                    {"file", warning.place.file},
                    {"line", warning.place.line},
                    {"column", warning.place.column}});
  }
  return list;
}

}  // namespace

std::string toJson(const Warnings& warnings) {
  return dumped(jsonOf(warnings));
}

std::string toJson(const MotionLibrary& library) {
  nlohmann::json clips = nlohmann::json::array();
  for (const LibraryClip& clip : library.clips)
    clips.push_back({{"name", clip.name}, {"frames", clip.frameCount}, {"mirrored", clip.mirrored}});
  return dumped({{"hash", hexDigits(library.hash)},
                 {"fps", library.frames.framesPerSecond},
                 {"frames", library.frames.frameCount()},
                 {"transitions", library.graph.transitionCount()},
                 {"license", library.license},
                 {"clips", clips},
                 {"notes", jsonOf(library.notes)}});
}

}  // namespace stridegraph
