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

/// A path with the way gone at each of its points.
class MeasuredPath {
 public:
  explicit MeasuredPath(std::vector<Vec2> points) : points_(std::move(points)), gone_(points_.size(), 0.0) {
    for (std::size_t i = 1; i < points_.size(); ++i)
      gone_[i] = gone_[i - 1] + (points_[i] - points_[i - 1]).norm();
  }

  const std::vector<Vec2>& points() const { return points_; }
  double lengthMetres() const { return gone_.back(); }

  PathPlace placeAt(double metres) const {
    const auto after = std::upper_bound(gone_.begin(), gone_.end(), metres);
    if (after == gone_.end()) return {points_.size() - 1, points_.back()};
    const auto next = static_cast<std::size_t>(after - gone_.begin());
    const double share = (metres - gone_[next - 1]) / (gone_[next] - gone_[next - 1]);
    return {next, points_[next - 1] + share * (points_[next] - points_[next - 1])};
  }

 private:
  std::vector<Vec2> points_;
  std::vector<double> gone_;
};

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
  MeasuredPath measured(withoutRepeats(path));
  if (measured.points().size() > 2) measured = MeasuredPath(withoutNeedlessPoints(plan, measured.points()));
  for (std::size_t round = 0; round < rounds && measured.points().size() > 2; ++round) {
    const std::vector<Vec2>& points = measured.points();
    const double length = measured.lengthMetres();
    const double first = random.uniform(0.0, length);
    const double second =
        std::clamp(first + random.uniform(-kLongestCutMetres, kLongestCutMetres), 0.0, length);
    const PathPlace from = measured.placeAt(std::min(first, second));
    const PathPlace to = measured.placeAt(std::max(first, second));
    if (from.next == to.next || !plan.isFree(from.point, to.point)) continue;
    // The cut pieces of the old segments are free in theory; rounding must not say otherwise.
    if (!plan.isFree(points[from.next - 1], from.point) || !plan.isFree(to.point, points[to.next])) continue;
    std::vector<Vec2> cut(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(from.next));
    cut.push_back(from.point);
    cut.push_back(to.point);
    cut.insert(cut.end(), points.begin() + static_cast<std::ptrdiff_t>(to.next), points.end());
    measured = MeasuredPath(withoutRepeats(cut));
  }
  const std::vector<Vec2>& points = measured.points();
  return points.size() > 2 ? withoutNeedlessPoints(plan, points) : points;
}

}  // namespace stridegraph
