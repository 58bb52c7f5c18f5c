#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graph/library.h"
#include "scene/scene.h"
#include "state/camera.h"
#include "walk/walk_planner.h"

namespace stridegraph {

enum class Tool { kSelect, kBlock, kMoving, kArea, kStart, kGoal, kWalker };

enum class ItemKind { kNothing, kObstacle, kMoving, kArea, kStart, kGoal };

/// What the pointer touches or has chosen.
struct Item {
  ItemKind kind = ItemKind::kNothing;
  /// Into Scene::obstacles, moving, or constraints.areas; for start and goal the walker: 0 is the scene's
  /// own, 1 the first of Scene::walkers.
  std::size_t index = 0;

  bool operator==(const Item&) const = default;
};

enum class HandleKind { kNone, kBody, kCorner, kEdge, kHeading, kTrackPoint };

/// A part of an item that can be dragged. For corners and edges, which sides move: -1 low, +1 high, 0
/// neither.
struct Handle {
  Item item;
  HandleKind kind = HandleKind::kNone;
  int sideX = 0;
  int sideZ = 0;
  std::size_t point = 0;  ///< Of a track, for kTrackPoint.
};

/// A change of the scene that is still under the pointer. It becomes one step of the history when let go.
struct Drag {
  Handle handle;
  Vec2 grabbedAt = Vec2::Zero();    ///< Floor coordinates, at planeHeight.
  double planeHeight = 0.0;         ///< Height of the plane along which the pointer moves, metres.
  std::optional<Tool> drawnWith;    ///< Set while a new item is being drawn.
  std::optional<Item> selectAfter;  ///< What is chosen once it is let go.
  Scene before;
  Scene preview;
  bool moved = false;
};

/// Earlier and later scenes, each with the name of the step that leads away from it or to it.
struct HistoryStep {
  std::string label;
  std::string mergeKey;  ///< Steps in a row that share one are a single step; empty merges with nothing.
  Scene scene;
};
struct History {
  std::vector<HistoryStep> past;
  std::vector<HistoryStep> future;
};

struct PlanSettings {
  PlannerKind planner = PlannerKind::kPrm;
  SearchKind search = SearchKind::kGuided;
  double goalRadiusMetres = 0.1;
};

/// When the walk is planned again.
struct Replanning {
  bool wanted = false;
  double changedAtSeconds = 0.0;  ///< Of the latest change.
  double plannedAtSeconds = -1e9;
  double lastMilliseconds = 0.0;  ///< How long the latest plan took.
  unsigned generation = 0;        ///< Grows with every plan, so that what is derived from it can follow.
  bool wentOn = false;            ///< The walk was under way in an earlier scene and goes on in this one.
  std::optional<AnytimePlan> improving;  ///< While a better walk than that on screen is looked for.
  std::optional<Plan> better;  ///< Found, but on screen the body would jump; shown when it would not.
};

struct Playback {
  double seconds = 0.0;
  double speed = 1.0;  ///< 0.1..2.
  bool playing = false;
  bool loop = true;
};

struct ViewOptions {
  bool dark = false;
  bool roadmap = true;
  bool path = true;
  bool subgoals = true;
  bool trail = true;
  bool footprints = true;
  bool tintBlends = false;
  bool startsPlaying = true;  ///< Whether a newly opened scene plays at once.
};

/// A sentence shown for a while over the view.
struct Notice {
  std::string text;
  double untilSeconds = 0.0;
  bool problem = false;
};

/// Everything that the app knows. Panels read it and return commands; only apply() and the drag change it.
struct AppState {
  Scene scene;
  History history;
  Item selection;
  Item hovered;
  Tool tool = Tool::kSelect;
  std::optional<Drag> drag;

  std::shared_ptr<const MotionLibrary> library;  ///< Null until one is open.
  std::unique_ptr<const WalkPlanner> planner;    ///< Of that library.
  PlanSettings settings;
  Replanning replanning;
  std::optional<Plan> plan;
  std::string planError;  ///< Why nothing could be planned at all; empty otherwise.
  std::optional<PlanReport>
      troubleOnWay;  ///< Why the walk under way cannot follow an edit; it stays as it was.

  Playback playback;
  Camera camera;
  ViewOptions view;
  Notice notice;
  double nowSeconds = 0.0;

  /// The scene as it stands on screen: with the drag that is under way.
  const Scene& shownScene() const { return drag ? drag->preview : scene; }
  std::size_t walkerCount() const { return 1 + shownScene().walkers.size(); }
  /// The plan of a walker, 0 for the first; null while there is none.
  const Plan* planOf(std::size_t walker) const;
  bool hasWalk() const { return plan && plan->walk.frameCount() > 0; }
  /// Until the last walker is at its goal; 0 without any walk.
  double walkSeconds() const;
  bool canPlay() const { return walkSeconds() > 0.0; }
  /// The time on screen; without a walk that of the playhead, so that a walk that comes back goes on there.
  double shownSeconds() const;
  /// The first walk's frame that is on screen; 0 without a walk.
  std::size_t shownFrame() const;
};

/// What a plan says to people, in one sentence.
std::string statusSentence(const AppState& state);

}  // namespace stridegraph
