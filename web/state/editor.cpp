#include "state/editor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "math/floor_transform.h"
#include "scene/scene_limits.h"
#include "scene/track.h"
#include "state/items.h"
#include "state/track_edit.h"

namespace stridegraph {

namespace {

constexpr double kMarkerReachMetres = 0.5;
constexpr double kHeadingSnapDegrees = 5.0;
constexpr double kLeastDrawnMetres = 0.15;

double snapped(double value, bool free) {
  // Micrometres keep drawn scenes short as text and links even where nothing snaps.
  const double unit = free ? 1e-3 : kSnapMetres;
  return std::round(value / unit) * unit;
}

Vec2 snapped(const Vec2& point, bool free) {
  return {snapped(point.x(), free), snapped(point.y(), free)};
}

Vec2 roomSize(const Scene& scene) {
  return {scene.widthMetres, scene.depthMetres};
}

Vec2 insideRoom(const Scene& scene, const Vec2& point) {
  return point.cwiseMax(Vec2::Zero()).cwiseMin(roomSize(scene));
}

/// Distance along the ray to a block; infinite when it misses.
double distanceTo(const Rectangle& block, const Ray& ray) {
  const Vec3 low(block.centre.x() - block.size.x() / 2, 0.0, block.centre.y() - block.size.y() / 2);
  const Vec3 high(block.centre.x() + block.size.x() / 2, kBlockHeightMetres,
                  block.centre.y() + block.size.y() / 2);
  double enter = 0.0;
  double leave = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double inverse = 1.0 / ray.direction[axis];
    const double a = (low[axis] - ray.origin[axis]) * inverse;
    const double b = (high[axis] - ray.origin[axis]) * inverse;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave ? enter : std::numeric_limits<double>::infinity();
}

bool isNear(const CameraView& view, const Vec3& point, const PointerAt& pointer) {
  const std::optional<Vec2> at = view.project(point);
  return at && (*at - pointer.position).norm() <= pointer.reachPoints;
}

/// Start or goal under the pointer: on the marker, or as near as a finger can point where it is tiny.
bool isOnMarker(const Placement& placement, const CameraView& view, const PointerAt& pointer) {
  const Vec3 middle(placement.position.x(), 0.0, placement.position.y());
  if (isNear(view, middle, pointer)) return true;
  const std::optional<Vec2> floor = meetPlane(view.rayAt(pointer.position), 0.0);
  return floor && (*floor - placement.position).norm() <= kMarkerReachMetres;
}

/// The block that stands there now, if the item is one.
std::optional<Rectangle> shownBlock(const AppState& state, const Item& item) {
  const Scene& scene = state.shownScene();
  if (!isThere(scene, item)) return std::nullopt;
  if (item.kind == ItemKind::kObstacle) return scene.obstacles[item.index];
  if (item.kind == ItemKind::kMoving) return rectangleAt(scene.moving[item.index], state.shownSeconds());
  return std::nullopt;
}

/// Where handles on a rectangle are: areas lie flat.
double heightOf(const Item& item) {
  return item.kind == ItemKind::kArea ? 0.0 : kBlockHeightMetres;
}

double grabHeight(const Handle& handle, const AppState& state, const Ray& ray) {
  if (handle.kind == HandleKind::kCorner || handle.kind == HandleKind::kEdge) return heightOf(handle.item);
  const std::optional<Rectangle> block = shownBlock(state, handle.item);
  if (!block || handle.kind != HandleKind::kBody) return 0.0;
  const double along = distanceTo(*block, ray);
  return std::isfinite(along) ? std::clamp((ray.origin + along * ray.direction).y(), 0.0, kBlockHeightMetres)
                              : 0.0;
}

void moveItem(Drag& drag, const Vec2& by, bool free) {
  const Item& item = drag.handle.item;
  if (Rectangle* const moved = rectangleOf(drag.preview, item)) {
    const Rectangle& old = *rectangleOf(drag.before, item);
    const Vec2 corner = snapped(Vec2(old.centre - old.size / 2 + by), free);
    moved->centre = insideRoom(drag.preview, corner + old.size / 2);
  } else if (Placement* const placement = placementOf(drag.preview, item)) {
    const Vec2 old = placementOf(drag.before, item)->position;
    placement->position = insideRoom(drag.preview, snapped(Vec2(old + by), free));
  } else if (item.kind == ItemKind::kMoving) {
    const MovingObstacle& old = drag.before.moving[item.index];
    const Vec2 first = old.track.front().position;
    drag.preview.moving[item.index] =
        withTrackMoved(old, snapped(Vec2(first + by), free) - first, roomSize(drag.preview));
  }
}

void resizeRectangle(Drag& drag, const Vec2& at, bool free) {
  Rectangle& rectangle = *rectangleOf(drag.preview, drag.handle.item);
  const Rectangle& old = *rectangleOf(drag.before, drag.handle.item);
  const Vec2 to = insideRoom(drag.preview, snapped(at, free));
  const std::array<int, 2> sides = {drag.handle.sideX, drag.handle.sideZ};
  for (int axis = 0; axis < 2; ++axis) {
    const int side = sides[static_cast<std::size_t>(axis)];
    if (side == 0) continue;
    const double fixed = old.centre[axis] - side * old.size[axis] / 2;
    const double size = std::max(side * (to[axis] - fixed), kSmallestBlockMetres);
    rectangle.size[axis] = size;
    rectangle.centre[axis] = fixed + side * size / 2;
  }
}

void moveTrackPoint(Drag& drag, const Vec2& at, bool free) {
  const std::size_t index = drag.handle.item.index;
  const Vec2 to = insideRoom(drag.preview, snapped(at, free));
  drag.preview.moving[index] = withTrackPoint(drag.before.moving[index], drag.handle.point, to);
}

void turnPlacement(Drag& drag, const Vec2& at, bool free) {
  Placement& placement = *placementOf(drag.preview, drag.handle.item);
  const Vec2 arm = at - placement.position;
  if (arm.norm() < 1e-3) return;
  const double degrees = Angle::radians(std::atan2(arm.x(), arm.y())).degrees();
  const double unit = free ? 0.1 : kHeadingSnapDegrees;
  placement.heading = Angle::degrees(std::round(degrees / unit) * unit);
}

void drawItem(Drag& drag, const Vec2& at, bool free) {
  const Vec2 from = insideRoom(drag.preview, snapped(drag.grabbedAt, free));
  const Vec2 to = insideRoom(drag.preview, snapped(at, free));
  switch (*drag.drawnWith) {
    case Tool::kBlock:
    case Tool::kArea: {
      Rectangle& rectangle = *rectangleOf(drag.preview, drag.handle.item);
      rectangle.size = (to - from).cwiseAbs().cwiseMax(kSmallestBlockMetres);
      rectangle.centre = (from + to) / 2;
      break;
    }
    case Tool::kMoving:
      drag.preview.moving[drag.handle.item.index] =
          backAndForth({from, Vec2::Constant(kMovingBlockMetres)}, to, kUsualTrackSpeed);
      break;
    case Tool::kWalker:
      placementOf(drag.preview, drag.handle.item)->position = to;
      break;
    case Tool::kStart:
    case Tool::kGoal:
      turnPlacement(drag, at, free);
      break;
    case Tool::kSelect:
      break;
  }
}

std::string labelOf(const Drag& drag) {
  const std::string kind = kindName(drag.handle.item);
  if (drag.drawnWith) return placementOf(drag.before, drag.handle.item) ? "Place " + kind : "Draw " + kind;
  switch (drag.handle.kind) {
    case HandleKind::kHeading:
      return "Turn heading";
    case HandleKind::kTrackPoint:
      return "Change way";
    case HandleKind::kBody:
      return "Move " + kind;
    default:
      return "Resize " + kind;
  }
}

/// A new item of the smallest size there is, or a start or goal that is put there.
void beginItem(Drag& drag, const Vec2& at) {
  Scene& scene = drag.preview;
  switch (*drag.drawnWith) {
    case Tool::kBlock:
      drag.handle = {{ItemKind::kObstacle, scene.obstacles.size()}, HandleKind::kCorner, 1, 1};
      scene.obstacles.push_back({at, Vec2::Constant(kSmallestBlockMetres)});
      break;
    case Tool::kArea:
      drag.handle = {{ItemKind::kArea, scene.constraints.areas.size()}, HandleKind::kCorner, 1, 1};
      scene.constraints.areas.push_back({{at, Vec2::Constant(kSmallestBlockMetres)}, AreaKind::kAvoid});
      break;
    case Tool::kMoving:
      drag.handle = {{ItemKind::kMoving, scene.moving.size()}, HandleKind::kTrackPoint, 0, 0, 1};
      scene.moving.push_back(backAndForth({at, Vec2::Constant(kMovingBlockMetres)}, at, kUsualTrackSpeed));
      break;
    case Tool::kWalker:
      scene.walkers.push_back({{at, std::nullopt}, {at, std::nullopt}});
      drag.handle = {{ItemKind::kGoal, scene.walkers.size()}, HandleKind::kBody, 0, 0};
      break;
    case Tool::kStart:
    case Tool::kGoal:
      drag.handle = {{*drag.drawnWith == Tool::kStart ? ItemKind::kStart : ItemKind::kGoal, 0},
                     HandleKind::kHeading,
                     0,
                     0};
      placementOf(scene, drag.handle.item)->position = at;
      drag.moved = true;
      break;
    case Tool::kSelect:
      break;
  }
}

bool hasRoomForMore(const Scene& scene, Tool tool) {
  if (tool == Tool::kArea) return scene.constraints.areas.size() < kMostAreas;
  return tool != Tool::kWalker || scene.walkers.size() < kMostWalkers;
}

std::optional<Drag> beginDrawing(const AppState& state, const Vec2& floor, bool free) {
  if (!hasRoomForMore(state.scene, state.tool)) return std::nullopt;
  Drag drag;
  drag.before = drag.preview = state.scene;
  drag.grabbedAt = floor;
  drag.drawnWith = state.tool;
  beginItem(drag, insideRoom(state.scene, snapped(floor, free)));
  drag.selectAfter = drag.handle.item;
  return drag;
}

void addCorners(const Rectangle& rectangle, const Item& item, std::vector<PlacedHandle>& handles) {
  for (int z = -1; z <= 1; ++z) {
    for (int x = -1; x <= 1; ++x) {
      if (x == 0 && z == 0) continue;
      const HandleKind kind = x != 0 && z != 0 ? HandleKind::kCorner : HandleKind::kEdge;
      handles.push_back({{item, kind, x, z},
                         {rectangle.centre.x() + x * rectangle.size.x() / 2, heightOf(item),
                          rectangle.centre.y() + z * rectangle.size.y() / 2}});
    }
  }
}

}  // namespace

double headingDegrees(const Placement& placement) {
  return placement.heading ? placement.heading->wrapped().degrees() : 0.0;
}

std::vector<PlacedHandle> handlesOf(const Scene& scene, const Item& item) {
  std::vector<PlacedHandle> handles;
  if (const Rectangle* const rectangle = rectangleOf(scene, item)) addCorners(*rectangle, item, handles);
  if (const Placement* const placement = placementOf(scene, item)) {
    const Vec2 ahead = Heading::fromAngle(placement->heading.value_or(Angle())).direction();
    const Vec2 at = placement->position + kHeadingHandleMetres * ahead;
    handles.push_back({{item, HandleKind::kHeading, 0, 0}, {at.x(), 0.0, at.y()}});
  }
  if (item.kind == ItemKind::kMoving && isThere(scene, item)) {
    const std::vector<TrackPoint>& track = scene.moving[item.index].track;
    for (std::size_t i = 0; i < track.size(); ++i) {
      handles.push_back(
          {{item, HandleKind::kTrackPoint, 0, 0, i}, {track[i].position.x(), 0.0, track[i].position.y()}});
    }
  }
  return handles;
}

Item areaUnder(const AppState& state, const CameraView& view, const PointerAt& pointer) {
  const std::optional<Vec2> floor = meetPlane(view.rayAt(pointer.position), 0.0);
  const std::vector<Area>& areas = state.shownScene().constraints.areas;
  for (std::size_t i = areas.size(); floor && i-- > 0;) {
    const Vec2 apart = (*floor - areas[i].rectangle.centre).cwiseAbs();
    if ((apart.array() <= areas[i].rectangle.size.array() / 2).all()) return {ItemKind::kArea, i};
  }
  return {};
}

Handle handleUnder(const AppState& state, const CameraView& view, const PointerAt& pointer) {
  const Scene& scene = state.shownScene();
  for (const PlacedHandle& placed : handlesOf(scene, state.selection)) {
    if (isNear(view, placed.position, pointer)) return placed.handle;
  }
  for (std::size_t walker = 0; walker <= scene.walkers.size(); ++walker) {
    for (const ItemKind kind : {ItemKind::kStart, ItemKind::kGoal}) {
      const Item item{kind, walker};
      if (isOnMarker(*placementOf(scene, item), view, pointer)) return {item, HandleKind::kBody, 0, 0};
    }
  }
  const Ray ray = view.rayAt(pointer.position);
  Handle nearest;
  double nearestDistance = std::numeric_limits<double>::infinity();
  const auto look = [&](const Item& item) {
    const double distance = distanceTo(*shownBlock(state, item), ray);
    if (distance >= nearestDistance) return;
    nearestDistance = distance;
    nearest = {item, HandleKind::kBody, 0, 0};
  };
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i) look({ItemKind::kObstacle, i});
  for (std::size_t i = 0; i < scene.moving.size(); ++i) look({ItemKind::kMoving, i});
  if (nearest.kind != HandleKind::kNone || state.selection.kind != ItemKind::kArea) return nearest;
  const Item area = areaUnder(state, view, pointer);
  return area == state.selection ? Handle{area, HandleKind::kBody, 0, 0} : nearest;
}

std::optional<Drag> beginDrag(const AppState& state, const CameraView& view, const PointerAt& pointer) {
  const Ray ray = view.rayAt(pointer.position);
  if (state.tool != Tool::kSelect) {
    const std::optional<Vec2> floor = meetPlane(ray, 0.0);
    if (!floor || insideRoom(state.scene, *floor) != *floor) return std::nullopt;
    return beginDrawing(state, *floor, pointer.free);
  }
  const Handle handle = handleUnder(state, view, pointer);
  if (handle.kind == HandleKind::kNone) return std::nullopt;
  Drag drag;
  drag.handle = handle;
  drag.before = drag.preview = state.scene;
  drag.planeHeight = grabHeight(handle, state, ray);
  const std::optional<Vec2> at = meetPlane(ray, drag.planeHeight);
  if (!at) return std::nullopt;
  drag.grabbedAt = *at;
  drag.selectAfter = handle.item;
  return drag;
}

void moveDrag(Drag& drag, const CameraView& view, const PointerAt& pointer) {
  const std::optional<Vec2> at = meetPlane(view.rayAt(pointer.position), drag.planeHeight);
  if (!at) return;
  const double least = drag.drawnWith ? kLeastDrawnMetres : 0.0;
  if ((*at - drag.grabbedAt).norm() <= least) return;
  drag.moved = true;
  if (drag.drawnWith) return drawItem(drag, *at, pointer.free);
  if (drag.handle.kind == HandleKind::kBody) return moveItem(drag, *at - drag.grabbedAt, pointer.free);
  if (drag.handle.kind == HandleKind::kHeading) return turnPlacement(drag, *at, pointer.free);
  if (drag.handle.kind == HandleKind::kTrackPoint) return moveTrackPoint(drag, *at, pointer.free);
  resizeRectangle(drag, *at, pointer.free);
}

Commands finishDrag(const Drag& drag) {
  Commands commands;
  if (drag.moved) commands.push_back(EditScene{labelOf(drag), drag.preview});
  const bool nothingDrawn = drag.drawnWith && !drag.moved;
  if (drag.selectAfter && !nothingDrawn) commands.push_back(Select{*drag.selectAfter});
  const bool drawsMore =
      drag.drawnWith == Tool::kBlock || drag.drawnWith == Tool::kArea || drag.drawnWith == Tool::kWalker;
  if (drag.drawnWith && drag.moved && !drawsMore) commands.push_back(ChooseTool{Tool::kSelect});
  return commands;
}

Scene nudged(const Scene& scene, const Item& item, const Vec2& by) {
  Scene moved = scene;
  if (Rectangle* const rectangle = rectangleOf(moved, item)) {
    rectangle->centre = insideRoom(scene, rectangle->centre + by);
  } else if (Placement* const placement = placementOf(moved, item)) {
    placement->position = insideRoom(scene, placement->position + by);
  } else if (item.kind == ItemKind::kMoving && isThere(scene, item)) {
    moved.moving[item.index] = withTrackMoved(moved.moving[item.index], by, roomSize(scene));
  }
  return moved;
}

}  // namespace stridegraph
