#include "path/shortcut.h"

#include <algorithm>

#include "path/polyline.h"

namespace stridegraph {

namespace {

/// Places further apart along the path hardly ever see each other.
constexpr double kLongestCutMetres = 30.0;

/// A place on a path: on the segment that ends at point `next`.
struct PathPlace {
  std::size_t next = 0;
  Vec2 point = Vec2::Zero();
};

PathPlace placeAt(const std::vector<Vec2>& path, double lengthMetres) {
  double left = lengthMetres;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec2 along = path[i] - path[i - 1];
    const double length = along.norm();
    if (left < length) return {i, path[i - 1] + (left / length) * along};
    left -= length;
  }
  return {path.size() - 1, path.back()};
}

/// Leaves out points whose neighbours see each other, from the start on.
std::vector<Vec2> withoutNeedlessPoints(const FloorPlan& plan, const std::vector<Vec2>& path) {
  std::vector<Vec2> kept = {path.front()};
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    if (!plan.isFree(kept.back(), path[i + 1])) kept.push_back(path[i]);
  }
  kept.push_back(path.back());
  return kept;
}

}  // namespace

std::vector<Vec2> shortcut(const FloorPlan& plan, std::span<const Vec2> path, std::size_t rounds,
                           Random& random) {
  std::vector<Vec2> points = withoutRepeats(path);
  for (std::size_t round = 0; round < rounds && points.size() > 2; ++round) {
    const double length = polylineLength(points);
    const double first = random.uniform(0.0, length);
    const double second =
        std::clamp(first + random.uniform(-kLongestCutMetres, kLongestCutMetres), 0.0, length);
    const PathPlace from = placeAt(points, std::min(first, second));
    const PathPlace to = placeAt(points, std::max(first, second));
    if (from.next == to.next || !plan.isFree(from.point, to.point)) continue;
    // The cut pieces of the old segments are free in theory; rounding must not say otherwise.
    if (!plan.isFree(points[from.next - 1], from.point) || !plan.isFree(to.point, points[to.next])) continue;
    std::vector<Vec2> cut(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(from.next));
    cut.push_back(from.point);
    cut.push_back(to.point);
    cut.insert(cut.end(), points.begin() + static_cast<std::ptrdiff_t>(to.next), points.end());
    points = withoutRepeats(cut);
  }
  return points.size() > 2 ? withoutNeedlessPoints(plan, points) : points;
}

}  // namespace stridegraph
