#include <vector>

#include "base/hash.h"
#include "base/utf8.h"
#include "made_scene.h"
#include "scene/base64_url.h"
#include "scene/scene_json.h"
#include "scene/scene_link.h"
#include "target.h"
#include "text_checks.h"

namespace stridegraph::fuzz {
namespace {

/// The bytes as a link's version and body, with a checksum that holds.
std::string forgedLink(Bytes body) {
  std::vector<std::uint8_t> bytes(body.begin(), body.end());
  const std::uint64_t hash = stableHash(bytes);
  const std::uint64_t folded = (hash ^ (hash >> 32U)) & 0xffffffffU;
  for (unsigned shift = 0; shift < 32; shift += 8)
    bytes.push_back(static_cast<std::uint8_t>(folded >> shift));
  return "s=" + toBase64Url(bytes);
}

void requireSound(const SharedScene& shared) {
  require(checkScene(shared.scene).has_value(), "a scene from a link keeps to its ranges");
  require(isUtf8(shared.scene.name), "the name of a scene from a link is UTF-8");
  require(isUtf8(shared.search), "the name of a search from a link is UTF-8");
  const Result<Scene> saved = readSceneJson(writeSceneJson(shared.scene));
  if (!saved) throw BrokenPromise("a scene from a link can be saved: " + describe(saved.error()));
}

void requireSame(const SharedScene& a, const SharedScene& b) {
  require(writeSceneJson(a.scene) == writeSceneJson(b.scene), "a link keeps the scene");
  require(a.search == b.search && a.libraryHash == b.libraryHash, "a link keeps search and library");
}

/// Follows a link; what it leads to is sound and makes the same link.
void follow(std::string_view link) {
  const Result<SharedScene> shared = decodeLink(link);
  if (!shared) return fuzz::requireSound(shared.error(), 1);
  requireSound(*shared);
  const Result<SharedScene> again = decodeLink(encodeLink(*shared));
  require(again.has_value(), "a link can be made of what a link led to");
  requireSame(*shared, *again);
}

/// A scene of any values that a scene may have is the same at the other end.
void share(Bytes bytes) {
  Input input(bytes);
  SharedScene shared;
  shared.libraryHash = input.word();
  shared.scene = madeScene(input);
  if (!checkScene(shared.scene)) return;
  const Result<SharedScene> followed = decodeLink(encodeLink(shared));
  require(followed.has_value(), "a link leads somewhere");
  requireSame(shared, *followed);
}

}  // namespace

void tryLink(Bytes bytes) {
  follow({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  follow(forgedLink(bytes));
  share(bytes);
}

}  // namespace stridegraph::fuzz
