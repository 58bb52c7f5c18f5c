#include "base/utf8.h"
#include "scene/scene_json.h"
#include "target.h"
#include "text_checks.h"

namespace stridegraph::fuzz {

void tryScene(Bytes bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const Result<Scene> scene = readSceneJson(text, "fuzz.json");
  if (!scene) return requireSound(scene.error(), mostLines(text));
  require(checkScene(*scene).has_value(), "a scene that is read keeps to its ranges");
  require(isUtf8(scene->name), "the name of a scene is UTF-8");
  const std::string written = writeSceneJson(*scene);
  const Result<Scene> back = readSceneJson(written, "written.json");
  if (!back) throw BrokenPromise("a scene that is written can be read: " + describe(back.error()));
  require(writeSceneJson(*back) == written, "a scene stays the same from writing to writing");
}

}  // namespace stridegraph::fuzz
