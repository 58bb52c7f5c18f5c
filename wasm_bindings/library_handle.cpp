#include "library_handle.h"

#include <emscripten/emscripten.h>
#include <fmt/format.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

#include "base/hash.h"
#include "graph/sgraph_file.h"
#include "js_values.h"
#include "options.h"
#include "plan_handle.h"
#include "scene/scene_json.h"
#include "walk_values.h"

namespace stridegraph::bindings {

using emscripten::val;

namespace {

/// What both ways to plan are asked for.
struct Asked {
  Scene scene;
  PlanOptions options;
};

Result<Asked> readAsked(const val& scene, const val& options) {
  Result<Scene> room = readSceneJson(textFrom(scene));
  if (!room) return fail(std::move(room));
  Result<PlanOptions> read = readPlanOptions(options);
  if (!read) return fail(std::move(read));
  read->clock = [] { return emscripten_get_now(); };
  return Asked{*std::move(room), *std::move(read)};
}

}  // namespace

LibraryHandle::LibraryHandle(MotionLibrary library)
    : session_(std::make_shared<Session>(std::move(library))) {}

val LibraryHandle::open(const val& bytes) {
  const auto copy = emscripten::convertJSArrayToNumberVector<std::uint8_t>(bytes);
  Result<MotionLibrary> library = readSgraph(copy);
  if (!library) return refuse(library.error());
  return succeed(val(std::make_shared<LibraryHandle>(*std::move(library))));
}

val LibraryHandle::startPlan(const val& scene, const val& options) {
  const Result<Asked> asked = readAsked(scene, options);
  if (!asked) return refuse(asked.error());
  return answer(session_->planner.begin(asked->scene, asked->options));
}

val LibraryHandle::startReplan(const val& scene, double atSeconds, const val& options) {
  const Result<Asked> asked = readAsked(scene, options);
  if (!asked) return refuse(asked.error());
  const std::optional<Plan>& underWay = session_->underWay;
  if (!underWay)
    return refuse(
        {ErrorCode::kInvalidArgument, "replan: found no walk under way, expected one planned before"});
  if (!(atSeconds >= 0.0 && atSeconds <= underWay->report.durationSeconds)) {
    return refuse(
        {ErrorCode::kInvalidArgument, fmt::format("replan: atSeconds is {}, expected 0 to the walk's {:.2f}",
                                                  atSeconds, underWay->report.durationSeconds)});
  }
  const auto frame = static_cast<std::size_t>(atSeconds * underWay->walk.framesPerSecond);
  return answer(session_->planner.beginOnward(*underWay, frame, asked->scene, asked->options));
}

val LibraryHandle::answer(Result<AnytimePlan> plan) {
  if (!plan) return refuse(plan.error());
  return succeed(val(std::make_shared<PlanHandle>(session_, *std::move(plan))));
}

val LibraryHandle::info() const {
  const MotionLibrary& library = this->library();
  val clips = val::array();
  for (const LibraryClip& clip : library.clips) {
    val value = val::object();
    value.set("name", textValue(clip.name));
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
  value.set("license", textValue(library.license));
  value.set("clips", clips);
  value.set("contactJoints", contactJoints);
  return value;
}

val LibraryHandle::skeleton() const {
  return skeletonValue(library());
}

val LibraryHandle::notes() const {
  return warningList(library().notes);
}

val LibraryHandle::toBytes() const {
  const std::vector<std::uint8_t> bytes = writeSgraph(library());
  return copyOut<std::uint8_t>(bytes);
}

}  // namespace stridegraph::bindings
