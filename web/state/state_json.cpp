#include "state/state_json.h"

#include <nlohmann/json.hpp>

#include "base/hash.h"
#include "scene/scene_json.h"
#include "scene/track.h"
#include "state/playback.h"
#include "state/walk_marks.h"

namespace stridegraph {

namespace {

const char* nameOf(CameraMode mode) {
  switch (mode) {
    case CameraMode::kOrbit:
      return "orbit";
    case CameraMode::kFollow:
      return "follow";
    case CameraMode::kTop:
      return "top";
  }
  return "";
}

const char* nameOf(Tool tool) {
  switch (tool) {
    case Tool::kSelect:
      return "select";
    case Tool::kBlock:
      return "block";
    case Tool::kMoving:
      return "moving";
    case Tool::kArea:
      return "area";
    case Tool::kWalker:
      return "walker";
    case Tool::kStart:
      return "start";
    case Tool::kGoal:
      return "goal";
  }
  return "";
}

/// Valid UTF-8 whatever names a file holds.
std::string dumped(const nlohmann::json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

nlohmann::json planJson(const AppState& state) {
  const PlanReport& report = state.plan->report;
  nlohmann::json edges = nlohmann::json::array();
  for (const auto& [from, to] : report.edges) edges.push_back({from.value, to.value});
  nlohmann::json marks = nlohmann::json::array();
  for (const WalkMark& mark : walkMarks(report))
    marks.push_back({{"name", mark.name}, {"frame", mark.frame}});
  nlohmann::json others = nlohmann::json::array();
  for (const Plan& other : state.plan->others) {
    others.push_back(
        {{"status", std::string(planStatusName(other.report.status))}, {"frames", other.report.frames}});
  }
  return {{"status", std::string(planStatusName(report.status))},
          {"others", others},
          {"edges", edges},
          {"frames", report.frames},
          {"marks", marks},
          {"arrival_error_m", report.arrivalErrorMetres},
          {"ends_standing", report.endsStanding},
          {"path_length_m", report.pathLengthMetres},
          {"motion_length_m", report.motionLengthMetres},
          {"total_ms", report.totalMilliseconds}};
}

nlohmann::json rootsJson(const AppState& state) {
  nlohmann::json roots = nlohmann::json::array();
  for (std::size_t walker = 0; walker < state.walkerCount(); ++walker) {
    const std::optional<Pose> pose = shownPose(state, walker);
    if (!pose) break;
    roots.push_back({pose->rootPosition.x(), pose->rootPosition.y(), pose->rootPosition.z()});
  }
  return roots;
}

nlohmann::json movingJson(const AppState& state) {
  nlohmann::json places = nlohmann::json::array();
  for (const MovingObstacle& moving : state.shownScene().moving) {
    const Vec2 at = trackPosition(moving, state.shownSeconds());
    places.push_back({at.x(), at.y()});
  }
  return places;
}

}  // namespace

std::string toJson(const AppState& state) {
  nlohmann::json json = {
      {"sentence", statusSentence(state)},
      {"planning",
       state.replanning.wanted || state.drag.has_value() || state.replanning.improving.has_value()},
      {"plans", state.replanning.generation},
      {"went_on", state.replanning.wentOn},
      {"frame", state.shownFrame()},
      {"seconds", state.shownSeconds()},
      {"walk_seconds", state.walkSeconds()},
      {"playing", state.playback.playing},
      {"roots", rootsJson(state)},
      {"moving", movingJson(state)},
      {"camera", nameOf(state.camera.mode)},
      {"camera_moving", !(state.camera.current == state.camera.wanted)},
      {"tool", nameOf(state.tool)},
      {"planner", std::string(plannerName(state.settings.planner))},
      {"search", std::string(searchName(state.settings.search))},
      {"notice", state.nowSeconds < state.notice.untilSeconds ? state.notice.text : ""},
      {"undo_steps", state.history.past.size()},
      {"redo_steps", state.history.future.size()},
      {"scene", nlohmann::json::parse(writeSceneJson(state.shownScene()), nullptr, false)},
      {"library_hash", state.library ? hexDigits(state.library->hash) : ""},
  };
  json["plan"] = state.plan ? planJson(state) : nlohmann::json();
  if (!json["roots"].empty()) json["root"] = json["roots"][0];
  return dumped(json);
}

std::string letteringJson(bool isWaiting, const std::vector<std::string>& missing) {
  return dumped({{"waiting", isWaiting}, {"missing", missing}});
}

}  // namespace stridegraph
