#include "library_handle.h"

#include <emscripten/emscripten.h>

#include <memory>
#include <utility>

#include "base/hash.h"
#include "graph/sgraph_file.h"
#include "js_values.h"
#include "options.h"
#include "scene/scene_json.h"
#include "walk_values.h"

namespace stridegraph::bindings {

using emscripten::val;

LibraryHandle::LibraryHandle(MotionLibrary library)
    : planner_(std::make_shared<const MotionLibrary>(std::move(library))) {}

val LibraryHandle::open(const val& bytes) {
  const auto copy = emscripten::convertJSArrayToNumberVector<std::uint8_t>(bytes);
  Result<MotionLibrary> library = readSgraph(copy);
  if (!library) return refuse(library.error());
  return succeed(val(std::make_shared<LibraryHandle>(*std::move(library))));
}

val LibraryHandle::plan(const std::string& scene, const val& options) const {
  const Result<Scene> room = readSceneJson(scene);
  if (!room) return refuse(room.error());
  Result<PlanOptions> read = readPlanOptions(options);
  if (!read) return refuse(read.error());
  read->clock = [] { return emscripten_get_now(); };
  const Result<Plan> plan = planner_.plan(*room, *read);
  if (!plan) return refuse(plan.error());
  return succeed(planValue(planner_.library().skeleton, *plan));
}

val LibraryHandle::info() const {
  const MotionLibrary& library = planner_.library();
  val clips = val::array();
  for (const LibraryClip& clip : library.clips) {
    val value = val::object();
    value.set("name", clip.name);
    value.set("firstFrame", clip.firstFrame);
    value.set("frames", clip.frameCount);
    value.set("mirrored", clip.mirrored);
    clips.call<void>("push", value);
  }
  val contactJoints = val::array();
  for (const JointIndex joint : library.contactJoints) contactJoints.call<void>("push", joint.value);

  val value = val::object();
  value.set("hash", hexDigits(library.hash));
  value.set("fps", library.frames.framesPerSecond);
  value.set("frames", static_cast<double>(library.frames.frameCount()));
  value.set("nodes", static_cast<double>(library.graph.nodes.size()));
  value.set("clipPieces", static_cast<double>(library.graph.clipPieceCount()));
  value.set("transitions", static_cast<double>(library.graph.transitionCount()));
  value.set("thresholdMetres", library.params.thresholdMetres);
  value.set("transitionFrames", library.params.transitionFrames);
  value.set("mirror", library.params.mirror);
  value.set("license", library.license);
  value.set("clips", clips);
  value.set("contactJoints", contactJoints);
  return value;
}

val LibraryHandle::skeleton() const {
  return skeletonValue(planner_.library().skeleton, planner_.library().layout);
}

val LibraryHandle::toBytes() const {
  const std::vector<std::uint8_t> bytes = writeSgraph(planner_.library());
  return copyOut<std::uint8_t>(bytes);
}

}  // namespace stridegraph::bindings
