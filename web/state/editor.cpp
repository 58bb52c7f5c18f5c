#include "state/editor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "math/floor_transform.h"

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

Vec2 insideRoom(const Scene& scene, const Vec2& point) {
  return {std::clamp(point.x(), 0.0, scene.widthMetres), std::clamp(point.y(), 0.0, scene.depthMetres)};
}

Placement& placementOf(Scene& scene, const Item& item) {
  return item.kind == ItemKind::kStart ? scene.start : scene.goal;
}

const Placement& placementOf(const Scene& scene, const Item& item) {
  return item.kind == ItemKind::kStart ? scene.start : scene.goal;
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

double grabHeight(const Handle& handle, const Scene& scene, const Ray& ray) {
  if (handle.kind == HandleKind::kCorner || handle.kind == HandleKind::kEdge) return kBlockHeightMetres;
  if (handle.item.kind != ItemKind::kObstacle) return 0.0;
  const double along = distanceTo(scene.obstacles[handle.item.obstacle], ray);
  return std::isfinite(along) ? std::clamp((ray.origin + along * ray.direction).y(), 0.0, kBlockHeightMetres)
                              : 0.0;
}

void moveItem(Drag& drag, const Vec2& by, bool free) {
  if (drag.handle.item.kind == ItemKind::kObstacle) {
    Rectangle& block = drag.preview.obstacles[drag.handle.item.obstacle];
    const Rectangle& old = drag.before.obstacles[drag.handle.item.obstacle];
    const Vec2 corner = snapped(Vec2(old.centre - old.size / 2 + by), free);
    block.centre = insideRoom(drag.preview, corner + old.size / 2);
    return;
  }
  Placement& placement = placementOf(drag.preview, drag.handle.item);
  const Vec2 old = placementOf(drag.before, drag.handle.item).position;
  placement.position = insideRoom(drag.preview, snapped(Vec2(old + by), free));
}

void resizeBlock(Drag& drag, const Vec2& at, bool free) {
  Rectangle& block = drag.preview.obstacles[drag.handle.item.obstacle];
  const Rectangle& old = drag.before.obstacles[drag.handle.item.obstacle];
  const Vec2 to = insideRoom(drag.preview, snapped(at, free));
  const std::array<int, 2> sides = {drag.handle.sideX, drag.handle.sideZ};
  for (int axis = 0; axis < 2; ++axis) {
    const int side = sides[static_cast<std::size_t>(axis)];
    if (side == 0) continue;
    const double fixed = old.centre[axis] - side * old.size[axis] / 2;
    const double size = std::max(side * (to[axis] - fixed), kSmallestBlockMetres);
    block.size[axis] = size;
    block.centre[axis] = fixed + side * size / 2;
  }
}

void turnPlacement(Drag& drag, const Vec2& at, bool free) {
  Placement& placement = placementOf(drag.preview, drag.handle.item);
  const Vec2 arm = at - placement.position;
  if (arm.norm() < 1e-3) return;
  const double degrees = Angle::radians(std::atan2(arm.x(), arm.y())).degrees();
  const double unit = free ? 0.1 : kHeadingSnapDegrees;
  placement.heading = Angle::degrees(std::round(degrees / unit) * unit);
}

void drawItem(Drag& drag, const Vec2& at, bool free) {
  if (*drag.drawnWith != Tool::kBlock) {
    turnPlacement(drag, at, free);
    return;
  }
  Rectangle& block = drag.preview.obstacles.back();
  const Vec2 from = insideRoom(drag.preview, snapped(drag.grabbedAt, free));
  const Vec2 to = insideRoom(drag.preview, snapped(at, free));
  block.size = (to - from).cwiseAbs().cwiseMax(kSmallestBlockMetres);
  block.centre = (from + to) / 2;
}

std::string labelOf(const Drag& drag) {
  const bool block = drag.handle.item.kind == ItemKind::kObstacle;
  if (drag.drawnWith) return block ? "Draw block" : "Place marker";
  if (drag.handle.kind == HandleKind::kHeading) return "Turn heading";
  if (drag.handle.kind == HandleKind::kBody) return block ? "Move block" : "Move marker";
  return "Resize block";
}

std::optional<Drag> beginDrawing(const AppState& state, const Vec2& floor, bool free) {
  Drag drag;
  drag.before = drag.preview = state.scene;
  drag.grabbedAt = floor;
  drag.drawnWith = state.tool;
  if (state.tool == Tool::kBlock) {
    drag.handle = {{ItemKind::kObstacle, state.scene.obstacles.size()}, HandleKind::kCorner, 1, 1};
    drag.preview.obstacles.push_back(
        {insideRoom(state.scene, snapped(floor, free)), Vec2::Constant(kSmallestBlockMetres)});
  } else {
    const ItemKind kind = state.tool == Tool::kStart ? ItemKind::kStart : ItemKind::kGoal;
    drag.handle = {{kind, 0}, HandleKind::kHeading, 0, 0};
    placementOf(drag.preview, drag.handle.item).position = insideRoom(state.scene, snapped(floor, free));
    drag.moved = true;
  }
  drag.selectAfter = drag.handle.item;
  return drag;
}

}  // namespace

double headingDegrees(const Placement& placement) {
  return placement.heading ? placement.heading->wrapped().degrees() : 0.0;
}

std::vector<PlacedHandle> handlesOf(const Scene& scene, const Item& item) {
  std::vector<PlacedHandle> handles;
  if (item.kind == ItemKind::kObstacle && item.obstacle < scene.obstacles.size()) {
    const Rectangle& block = scene.obstacles[item.obstacle];
    for (int z = -1; z <= 1; ++z) {
      for (int x = -1; x <= 1; ++x) {
        if (x == 0 && z == 0) continue;
        const HandleKind kind = x != 0 && z != 0 ? HandleKind::kCorner : HandleKind::kEdge;
        handles.push_back({{item, kind, x, z},
                           {block.centre.x() + x * block.size.x() / 2, kBlockHeightMetres,
                            block.centre.y() + z * block.size.y() / 2}});
      }
    }
  }
  if (item.kind == ItemKind::kStart || item.kind == ItemKind::kGoal) {
    const Placement& placement = placementOf(scene, item);
    const Vec2 ahead = Heading::fromAngle(placement.heading.value_or(Angle())).direction();
    const Vec2 at = placement.position + kHeadingHandleMetres * ahead;
    handles.push_back({{item, HandleKind::kHeading, 0, 0}, {at.x(), 0.0, at.y()}});
  }
  return handles;
}

Handle handleUnder(const AppState& state, const CameraView& view, const PointerAt& pointer) {
  const Scene& scene = state.shownScene();
  for (const PlacedHandle& placed : handlesOf(scene, state.selection)) {
    if (isNear(view, placed.position, pointer)) return placed.handle;
  }
  for (const ItemKind kind : {ItemKind::kStart, ItemKind::kGoal}) {
    const Item item{kind, 0};
    if (isOnMarker(placementOf(scene, item), view, pointer)) return {item, HandleKind::kBody, 0, 0};
  }
  const Ray ray = view.rayAt(pointer.position);
  Handle nearest;
  double nearestDistance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
    const double distance = distanceTo(scene.obstacles[i], ray);
    if (distance >= nearestDistance) continue;
    nearestDistance = distance;
    nearest = {{ItemKind::kObstacle, i}, HandleKind::kBody, 0, 0};
  }
  return nearest;
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
  drag.planeHeight = grabHeight(handle, state.scene, ray);
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
  resizeBlock(drag, *at, pointer.free);
}

Commands finishDrag(const Drag& drag) {
  Commands commands;
  if (drag.moved) commands.push_back(EditScene{labelOf(drag), drag.preview});
  const bool nothingDrawn = drag.drawnWith && !drag.moved;
  if (drag.selectAfter && !nothingDrawn) commands.push_back(Select{*drag.selectAfter});
  if (drag.drawnWith && drag.moved && *drag.drawnWith != Tool::kBlock) {
    commands.push_back(ChooseTool{Tool::kSelect});
  }
  return commands;
}

Scene nudged(const Scene& scene, const Item& item, const Vec2& by) {
  Scene moved = scene;
  if (item.kind == ItemKind::kObstacle && item.obstacle < moved.obstacles.size()) {
    Vec2& centre = moved.obstacles[item.obstacle].centre;
    centre = insideRoom(scene, centre + by);
  } else if (item.kind == ItemKind::kStart || item.kind == ItemKind::kGoal) {
    Vec2& position = placementOf(moved, item).position;
    position = insideRoom(scene, position + by);
  }
  return moved;
}

}  // namespace stridegraph
