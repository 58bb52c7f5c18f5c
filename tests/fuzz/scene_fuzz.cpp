#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/check.h"
#include "base/hash.h"
#include "scene/base64_url.h"
#include "scene/scene_json.h"
#include "scene/scene_link.h"

namespace stridegraph {
namespace {

/// What is read once reads the same from its own writing, as JSON and as a link.
void checkScenesSurvive(const SharedScene& shared) {
  STRIDEGRAPH_CHECK(checkScene(shared.scene).has_value());
  const std::string json = writeSceneJson(shared.scene);
  const Result<Scene> reread = readSceneJson(json);
  STRIDEGRAPH_CHECK(reread.has_value());
  STRIDEGRAPH_CHECK(writeSceneJson(*reread) == json);
  const std::string link = encodeLink(shared);
  const Result<SharedScene> followed = decodeLink(link);
  STRIDEGRAPH_CHECK(followed.has_value());
  STRIDEGRAPH_CHECK(encodeLink(*followed) == link);
}

/// The bytes as a link's version and body, with a checksum that holds.
std::string forgedLink(std::vector<std::uint8_t> bytes) {
  const std::uint64_t hash = stableHash(bytes);
  const std::uint64_t folded = (hash ^ (hash >> 32U)) & 0xffffffffU;
  for (unsigned shift = 0; shift < 32; shift += 8)
    bytes.push_back(static_cast<std::uint8_t>(folded >> shift));
  return "s=" + toBase64Url(bytes);
}

void readEverywhere(std::string_view text) {
  if (Result<Scene> scene = readSceneJson(text)) {
    SharedScene shared;
    shared.scene = *scene;
    checkScenesSurvive(shared);
  }
  if (Result<SharedScene> shared = decodeLink(text)) checkScenesSurvive(*shared);
  if (Result<SharedScene> shared = decodeLink(forgedLink({text.begin(), text.end()})))
    checkScenesSurvive(*shared);
}

}  // namespace
}  // namespace stridegraph

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  stridegraph::readEverywhere({reinterpret_cast<const char*>(data), size});
  return 0;
}
