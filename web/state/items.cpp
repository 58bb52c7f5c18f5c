#include "state/items.h"

#include <cstddef>

namespace stridegraph {

namespace {

template <typename List>
void eraseAt(List& list, std::size_t index) {
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(index));
}

template <typename SceneType>
auto placementIn(SceneType& scene, const Item& item) -> decltype(&scene.start) {
  const bool start = item.kind == ItemKind::kStart;
  if ((!start && item.kind != ItemKind::kGoal) || item.index > scene.walkers.size()) return nullptr;
  if (item.index == 0) return start ? &scene.start : &scene.goal;
  auto& walker = scene.walkers[item.index - 1];
  return start ? &walker.start : &walker.goal;
}

template <typename SceneType>
auto rectangleIn(SceneType& scene, const Item& item) -> decltype(&scene.obstacles[0]) {
  if (item.kind == ItemKind::kObstacle && item.index < scene.obstacles.size()) {
    return &scene.obstacles[item.index];
  }
  if (item.kind == ItemKind::kArea && item.index < scene.constraints.areas.size()) {
    return &scene.constraints.areas[item.index].rectangle;
  }
  return nullptr;
}

}  // namespace

Placement* placementOf(Scene& scene, const Item& item) {
  return placementIn(scene, item);
}
const Placement* placementOf(const Scene& scene, const Item& item) {
  return placementIn(scene, item);
}

Rectangle* rectangleOf(Scene& scene, const Item& item) {
  return rectangleIn(scene, item);
}
const Rectangle* rectangleOf(const Scene& scene, const Item& item) {
  return rectangleIn(scene, item);
}

bool isThere(const Scene& scene, const Item& item) {
  if (item.kind == ItemKind::kMoving) return item.index < scene.moving.size();
  return placementOf(scene, item) != nullptr || rectangleOf(scene, item) != nullptr;
}

bool isRemovable(const Scene& scene, const Item& item) {
  if (!isThere(scene, item)) return false;
  return placementOf(scene, item) == nullptr || item.index > 0;
}

Scene without(const Scene& scene, const Item& item) {
  Scene rest = scene;
  if (!isRemovable(scene, item)) return rest;
  switch (item.kind) {
    case ItemKind::kObstacle:
      eraseAt(rest.obstacles, item.index);
      break;
    case ItemKind::kMoving:
      eraseAt(rest.moving, item.index);
      break;
    case ItemKind::kArea:
      eraseAt(rest.constraints.areas, item.index);
      break;
    case ItemKind::kStart:
    case ItemKind::kGoal:
      eraseAt(rest.walkers, item.index - 1);
      break;
    case ItemKind::kNothing:
      break;
  }
  return rest;
}

std::string kindName(const Item& item) {
  switch (item.kind) {
    case ItemKind::kObstacle:
      return "block";
    case ItemKind::kMoving:
      return "moving block";
    case ItemKind::kArea:
      return "area";
    case ItemKind::kStart:
      return item.index == 0 ? "start" : "walker";
    case ItemKind::kGoal:
      return item.index == 0 ? "goal" : "walker";
    case ItemKind::kNothing:
      break;
  }
  return "nothing";
}

}  // namespace stridegraph
