#include <emscripten/bind.h>
#include <malloc.h>

#include <memory>
#include <string>

#include "base/hash.h"
#include "builder_handle.h"
#include "clip_reader.h"
#include "js_values.h"
#include "library_handle.h"
#include "option_reader.h"
#include "plan_handle.h"
#include "scene/scene_json.h"
#include "scene/scene_link.h"
#include "walk_values.h"

namespace stridegraph::bindings {
namespace {

using emscripten::val;

/// Names of all error codes, in the order of core's list.
val errorCodes() {
  val names = val::array();
  for (const ErrorCode code : kAllErrorCodes) names.call<void>("push", std::string(errorCodeName(code)));
  return names;
}

/// The refusal of an argument that never came as far as core.
val invalidArgument(const val& message) {
  return refuse(Error{ErrorCode::kInvalidArgument, textFrom(message)});
}

/// Bytes of the heap in use: the figure that must stay flat.
double usedBytes() {
  return static_cast<double>(mallinfo().uordblks);
}

Result<std::uint64_t> readHash(const std::string& digits) {
  std::uint64_t hash = 0;
  bool valid = digits.size() == 16;
  for (const char digit : digits) {
    const std::size_t value = std::string_view("0123456789abcdef").find(digit);
    valid = valid && value != std::string_view::npos;
    hash = hash << 4U | (value & 0xFU);
  }
  if (valid) return hash;
  return fail(ErrorCode::kInvalidArgument,
              "link options: libraryHash is \"" + digits + "\", expected 16 lower-case hexadecimal digits");
}

/// {value: fragment}; options as LinkOptions in stridegraph.d.ts.
val encode(const val& sceneText, const val& options) {
  Result<Scene> scene = readSceneJson(textFrom(sceneText));
  if (!scene) return refuse(scene.error());
  SharedScene shared{.scene = *std::move(scene)};
  OptionReader reader(options, "link options");
  if (const auto search = reader.text("search")) shared.search = *search;
  const auto digits = reader.text("libraryHash");
  if (const Result<void> checked = reader.check(); !checked) return refuse(checked.error());
  if (digits) {
    const Result<std::uint64_t> hash = readHash(*digits);
    if (!hash) return refuse(hash.error());
    shared.libraryHash = *hash;
  }
  return succeed(val(encodeLink(shared)));
}

/// {value: {scene: JSON text, search, libraryHash: digits or null}}.
val decode(const val& fragment) {
  const Result<SharedScene> shared = decodeLink(textFrom(fragment));
  if (!shared) return refuse(shared.error());
  val value = val::object();
  value.set("scene", textValue(writeSceneJson(shared->scene)));
  value.set("search", textValue(shared->search));
  value.set("libraryHash", shared->libraryHash == 0 ? val::null() : val(hexDigits(shared->libraryHash)));
  return succeed(value);
}

/// {value: {warnings}}, see SceneInspection in stridegraph.d.ts.
val inspectScene(const val& sceneText) {
  Warnings notes;
  const Result<Scene> scene = readSceneJson(textFrom(sceneText), "scene", &notes);
  if (!scene) return refuse(scene.error());
  val value = val::object();
  value.set("warnings", warningList(notes));
  return succeed(value);
}

}  // namespace

EMSCRIPTEN_BINDINGS(stridegraph) {
  using namespace emscripten;
  class_<LibraryHandle>("Library")
      .smart_ptr<std::shared_ptr<LibraryHandle>>("LibraryPointer")
      .class_function("open", &LibraryHandle::open)
      .function("startPlan", &LibraryHandle::startPlan)
      .function("startReplan", &LibraryHandle::startReplan)
      .function("info", &LibraryHandle::info)
      .function("skeleton", &LibraryHandle::skeleton)
      .function("notes", &LibraryHandle::notes)
      .function("toBytes", &LibraryHandle::toBytes);
  class_<PlanHandle>("Plan")
      .smart_ptr<std::shared_ptr<PlanHandle>>("PlanPointer")
      .function("walk", &PlanHandle::walk)
      .function("step", &PlanHandle::step)
      .function("isDone", &PlanHandle::isDone)
      .function("progress", &PlanHandle::progress);
  class_<BuilderHandle>("Builder")
      .smart_ptr<std::shared_ptr<BuilderHandle>>("BuilderPointer")
      .class_function("create", &BuilderHandle::create)
      .function("addClip", &BuilderHandle::addClip)
      .function("start", &BuilderHandle::start)
      .function("step", &BuilderHandle::step)
      .function("progress", &BuilderHandle::progress)
      .function("framePairs", &BuilderHandle::framePairs)
      .function("finish", &BuilderHandle::finish);
  function("inspectClip", &inspectClip);
  function("inspectScene", &inspectScene);
  function("walkToBvh", &walkToBvh);
  function("walksToGlb", &walksToGlb);
  function("encodeLink", &encode);
  function("decodeLink", &decode);
  function("errorCodes", &errorCodes);
  function("invalidArgument", &invalidArgument);
  function("usedBytes", &usedBytes);
}

}  // namespace stridegraph::bindings
