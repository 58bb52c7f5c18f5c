#include "state/commands.h"

#include <algorithm>
#include <cmath>

#include "state/items.h"
#include "state/planning.h"

namespace stridegraph {

namespace {

constexpr std::size_t kLongestHistory = 200;
constexpr double kNoticeSeconds = 6.0;

void dropLostSelection(AppState& state) {
  if (!isThere(state.scene, state.selection)) state.selection = {};
}

void run(AppState& state, const EditScene& edit) {
  std::vector<HistoryStep>& past = state.history.past;
  const bool merges = !edit.mergeKey.empty() && !past.empty() && past.back().mergeKey == edit.mergeKey &&
                      state.history.future.empty();
  if (!merges) past.push_back({edit.label, edit.mergeKey, state.scene});
  if (past.size() > kLongestHistory) past.erase(past.begin());
  state.history.future.clear();
  state.scene = edit.scene;
  dropLostSelection(state);
  wantPlan(state);
}

void run(AppState& state, const OpenScene& open) {
  state.drag.reset();
  run(state, EditScene{open.label, open.scene});
  state.selection = {};
  state.tool = Tool::kSelect;
  state.playback.seconds = 0.0;
  state.playback.playing = state.view.startsPlaying;
}

void travel(AppState& state, std::vector<HistoryStep>& from, std::vector<HistoryStep>& to) {
  if (from.empty() || state.drag) return;
  to.push_back({from.back().label, "", state.scene});
  state.scene = from.back().scene;
  from.pop_back();
  dropLostSelection(state);
  wantPlan(state);
}

void run(AppState& state, const Undo&) {
  travel(state, state.history.past, state.history.future);
}
void run(AppState& state, const Redo&) {
  travel(state, state.history.future, state.history.past);
}
void run(AppState& state, const Select& select) {
  state.selection = select.item;
}

void run(AppState& state, const ChooseTool& choose) {
  state.tool = choose.tool;
  state.drag.reset();
}

void run(AppState& state, const DeleteSelection&) {
  if (!isRemovable(state.scene, state.selection)) return;
  const Item item = state.selection;
  state.selection = {};
  run(state, EditScene{"Delete " + kindName(item), without(state.scene, item)});
}

void run(AppState& state, const ChangeSettings& change) {
  state.settings = change.settings;
  wantPlan(state);
}

void run(AppState& state, const ChangePlayback& change) {
  state.playback = change.playback;
  state.playback.speed = std::clamp(state.playback.speed, 0.1, 2.0);
  state.playback.seconds = std::clamp(state.playback.seconds, 0.0, state.walkSeconds());
}

void run(AppState& state, const StepFrames& step) {
  if (!state.canPlay()) return;
  state.playback.playing = false;
  const double rate = state.library->frames.framesPerSecond;
  const double frame = std::floor(state.shownSeconds() * rate + 1e-6) + step.frames;
  state.playback.seconds = std::clamp(frame / rate, 0.0, state.walkSeconds());
}

void run(AppState& state, const ChangeView& change) {
  state.view = change.view;
}

void run(AppState& state, const ChooseCamera& choose) {
  Camera& camera = state.camera;
  if (camera.mode == CameraMode::kOrbit) camera.orbit = camera.wanted;
  camera.mode = choose.mode;
  switch (choose.mode) {
    case CameraMode::kOrbit:
      camera.wanted = camera.orbit;
      break;
    case CameraMode::kTop:
      camera.wanted = poseAboveRoom(state.scene.widthMetres, state.scene.depthMetres, choose.viewport);
      break;
    case CameraMode::kFollow:
      camera.wanted = camera.orbit;
      camera.wanted.pitchRadians = 0.28;
      camera.wanted.halfHeightMetres = 1.9;
      camera.wanted.targetHeight = 0.85;
      break;
  }
}

void run(AppState& state, const ShowWholeRoom& show) {
  Camera& camera = state.camera;
  const Scene& scene = state.scene;
  camera.orbit = poseOverRoom(scene.widthMetres, scene.depthMetres, show.viewport);
  if (camera.mode == CameraMode::kOrbit) camera.wanted = camera.orbit;
  if (camera.mode == CameraMode::kTop) {
    camera.wanted = poseAboveRoom(scene.widthMetres, scene.depthMetres, show.viewport);
  }
}

void run(AppState& state, const Say& say) {
  state.notice = {say.text, state.nowSeconds + kNoticeSeconds, say.problem};
}

}  // namespace

void apply(AppState& state, const Command& command) {
  std::visit([&state](const auto& each) { run(state, each); }, command);
}

void applyAll(AppState& state, const Commands& commands) {
  for (const Command& command : commands) apply(state, command);
}

}  // namespace stridegraph
