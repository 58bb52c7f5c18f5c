#include "path/polyline.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace stridegraph {

double polylineLength(std::span<const Vec2> path) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) length += (path[i] - path[i - 1]).norm();
  return length;
}

Vec2 pointAtLength(std::span<const Vec2> path, double lengthMetres) {
  STRIDEGRAPH_CHECK(!path.empty());
  double left = std::max(lengthMetres, 0.0);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec2 along = path[i] - path[i - 1];
    const double length = along.norm();
    if (left < length) return path[i - 1] + (left / length) * along;
    left -= length;
  }
  return path.back();
}

std::vector<Vec2> subgoals(std::span<const Vec2> path, double spacingMetres) {
  STRIDEGRAPH_CHECK(spacingMetres > 0.0);
  if (path.empty()) return {};
  const double length = polylineLength(path);
  const auto count = static_cast<std::size_t>(std::max(1.0, std::round(length / spacingMetres)));
  std::vector<Vec2> points;
  points.reserve(count);
  for (std::size_t i = 1; i < count; ++i) {
    points.push_back(pointAtLength(path, length * static_cast<double>(i) / static_cast<double>(count)));
  }
  points.push_back(path.back());
  return points;
}

std::vector<Vec2> withoutRepeats(std::span<const Vec2> path) {
  std::vector<Vec2> kept;
  for (const Vec2& point : path) {
    if (kept.empty() || point != kept.back()) kept.push_back(point);
  }
  return kept;
}

}  // namespace stridegraph
