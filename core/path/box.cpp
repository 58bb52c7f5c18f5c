#include "path/box.h"

namespace stridegraph {

namespace {

/// Whether the open box and the segment share a point (slab method).
bool segmentEntersBox(const Box& box, const Vec2& from, const Vec2& to) {
  double enter = 0.0;
  double leave = 1.0;
  const double origin[2] = {from.x(), from.y()};
  const double along[2] = {to.x() - from.x(), to.y() - from.y()};
  const double low[2] = {box.minX, box.minZ};
  const double high[2] = {box.maxX, box.maxZ};
  for (int axis = 0; axis < 2; ++axis) {
    if (along[axis] == 0.0) {
      if (!(origin[axis] > low[axis] && origin[axis] < high[axis])) return false;
      continue;
    }
    const double first = (low[axis] - origin[axis]) / along[axis];
    const double second = (high[axis] - origin[axis]) / along[axis];
    const double near = std::min(first, second);
    const double far = std::max(first, second);
    // A segment that ends on the outline touches the open box nowhere.
    if (far <= 0.0 || near >= 1.0) return false;
    enter = std::max(enter, near);
    leave = std::min(leave, far);
  }
  return enter < leave || (from == to);
}

}  // namespace

double squaredDistanceToSegment(const Vec2& point, const Vec2& from, const Vec2& to) {
  const Vec2 along = to - from;
  const double squaredLength = along.squaredNorm();
  const double fraction =
      squaredLength > 0.0 ? std::clamp((point - from).dot(along) / squaredLength, 0.0, 1.0) : 0.0;
  return (from + fraction * along - point).squaredNorm();
}

bool segmentEntersGrownBox(const Box& box, double radius, const Vec2& from, const Vec2& to) {
  if (std::max(from.x(), to.x()) <= box.minX - radius || std::min(from.x(), to.x()) >= box.maxX + radius) {
    return false;
  }
  if (std::max(from.y(), to.y()) <= box.minZ - radius || std::min(from.y(), to.y()) >= box.maxZ + radius) {
    return false;
  }
  const Box wide{box.minX - radius, box.minZ, box.maxX + radius, box.maxZ};
  const Box tall{box.minX, box.minZ - radius, box.maxX, box.maxZ + radius};
  if (segmentEntersBox(wide, from, to) || segmentEntersBox(tall, from, to)) return true;
  const double squaredRadius = radius * radius;
  for (const double x : {box.minX, box.maxX}) {
    for (const double z : {box.minZ, box.maxZ}) {
      if (squaredDistanceToSegment({x, z}, from, to) < squaredRadius) return true;
    }
  }
  return false;
}

}  // namespace stridegraph
