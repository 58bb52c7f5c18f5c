#include "library_handle.h"

#include <emscripten/emscripten.h>
#include <fmt/format.h>

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

val LibraryHandle::plan(const std::string& scene, const val& options) {
  const Result<Scene> room = readSceneJson(scene);
  if (!room) return refuse(room.error());
  Result<PlanOptions> read = readPlanOptions(options);
  if (!read) return refuse(read.error());
  read->clock = [] { return emscripten_get_now(); };
  return answer(planner_.plan(*room, *read));
}

val LibraryHandle::replan(const std::string& scene, double atSeconds, const val& options) {
  const Result<Scene> room = readSceneJson(scene);
  if (!room) return refuse(room.error());
  Result<PlanOptions> read = readPlanOptions(options);
  if (!read) return refuse(read.error());
  read->clock = [] { return emscripten_get_now(); };
  if (!underWay_)
    return refuse(
        {ErrorCode::kInvalidArgument, "replan: found no walk under way, expected one planned before"});
  if (!(atSeconds >= 0.0 && atSeconds <= underWay_->report.durationSeconds)) {
    return refuse(
        {ErrorCode::kInvalidArgument, fmt::format("replan: atSeconds is {}, expected 0 to the walk's {:.2f}",
                                                  atSeconds, underWay_->report.durationSeconds)});
  }
  const double frame = atSeconds * underWay_->walk.framesPerSecond;
  return answer(planner_.replan(*underWay_, static_cast<std::size_t>(frame), *room, *read));
}

val LibraryHandle::answer(Result<Plan> plan) {
  if (!plan) return refuse(plan.error());
  val value = planValue(planner_.library().skeleton, *plan);
  if (plan->report.status == PlanStatus::kArrived) underWay_ = *std::move(plan);
  return succeed(value);
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
