#include "path/connectivity.h"

#include <array>
#include <numeric>
#include <utility>
#include <vector>

namespace stridegraph {

namespace {

/// Sets joined so far, each with the parity of its chain to its representative.
class ParityUnion {
 public:
  explicit ParityUnion(std::size_t count) : parent_(count), odd_(count, false) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  /// Joins two sets by a link of the given parity. False when they were joined before by a chain of the other
  /// parity: both together go round an odd number of times.
  bool join(std::size_t a, std::size_t b, bool odd) {
    const auto [rootA, oddA] = find(a);
    const auto [rootB, oddB] = find(b);
    const bool between = (oddA != oddB) != odd;
    if (rootA == rootB) return !between;
    parent_[rootB] = rootA;
    odd_[rootB] = between;
    return true;
  }

 private:
  std::pair<std::size_t, bool> find(std::size_t set) {
    std::size_t root = set;
    bool odd = false;
    while (parent_[root] != root) {
      odd = odd != odd_[root];
      root = parent_[root];
    }
    // Hang everything on the way below the root, so that chains stay short.
    bool oddToRoot = odd;
    while (parent_[set] != root && set != root) {
      const std::size_t next = parent_[set];
      const bool oddToNext = odd_[set];
      parent_[set] = root;
      odd_[set] = oddToRoot;
      oddToRoot = oddToRoot != oddToNext;
      set = next;
    }
    return {root, odd};
  }

  std::vector<std::size_t> parent_;
  std::vector<bool> odd_;
};

/// Whether a segment crosses the ray from `origin` towards +x. Half-open in z, so that a closed chain crosses
/// an even number of times exactly when it does not go round the origin.
bool crossesRay(const Vec2& origin, const Vec2& a, const Vec2& b) {
  if ((a.y() > origin.y()) == (b.y() > origin.y())) return false;
  const double turn = (b.x() - a.x()) * (origin.y() - a.y()) - (b.y() - a.y()) * (origin.x() - a.x());
  return (turn > 0.0) == (b.y() > a.y());
}

/// The sets, each with a point in it: rectangles first, then the half-planes left, right, below and above.
class Barrier {
 public:
  Barrier(const FloorPlan& plan, const Vec2& from, const Vec2& to)
      : plan_(plan),
        reach_(plan.radiusMetres() - FloorPlan::kTouchToleranceMetres),
        from_(from),
        to_(to),
        sets_(plan.boxes().size() + 4) {}

  /// Whether any closed chain parts the two places.
  bool parts() { return joinWalls() || joinRectanglesWithWalls() || joinRectangles(); }

 private:
  static constexpr std::size_t kWalls = 4;

  std::size_t wall(std::size_t side) const { return plan_.boxes().size() + side; }
  static Vec2 centreOf(const Box& box) { return {0.5 * (box.minX + box.maxX), 0.5 * (box.minZ + box.maxZ)}; }
  Vec2 wallPoint(std::size_t side) const {
    const double width = plan_.widthMetres();
    const double depth = plan_.depthMetres();
    const std::array<Vec2, kWalls> points = {Vec2(-1.0, 0.5 * depth), Vec2(width + 1.0, 0.5 * depth),
                                             Vec2(0.5 * width, -1.0), Vec2(0.5 * width, depth + 1.0)};
    return points[side];
  }

  /// Links two sets by the way through a point in both; true when that closes a parting chain.
  bool link(std::size_t a, const Vec2& pointA, const Vec2& both, std::size_t b, const Vec2& pointB) {
    bool odd = false;
    for (const Vec2& place : {from_, to_}) {
      odd = odd != (crossesRay(place, pointA, both) != crossesRay(place, both, pointB));
    }
    return !sets_.join(a, b, odd);
  }

  bool joinWalls() {
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
      for (const std::size_t other : {std::size_t{2}, std::size_t{3}}) {
        const Vec2 corner(wallPoint(side).x(), wallPoint(other).y());
        if (link(wall(side), wallPoint(side), corner, wall(other), wallPoint(other))) return true;
      }
    }
    return false;
  }

  bool joinRectanglesWithWalls() {
    for (std::size_t i = 0; i < plan_.boxes().size(); ++i) {
      const Box& box = plan_.boxes()[i];
      const Vec2 centre = centreOf(box);
      const Box wide = grown(box, reach_);
      // Within the grown rectangle and beyond the wall, halfway between their borders.
      const double left = std::min(wide.maxX, reach_);
      const double right = std::max(wide.minX, plan_.widthMetres() - reach_);
      const double below = std::min(wide.maxZ, reach_);
      const double above = std::max(wide.minZ, plan_.depthMetres() - reach_);
      const std::array<bool, kWalls> overlaps = {wide.minX < left, right < wide.maxX, wide.minZ < below,
                                                 above < wide.maxZ};
      const std::array<Vec2, kWalls> both = {
          Vec2(0.5 * (wide.minX + left), centre.y()), Vec2(0.5 * (right + wide.maxX), centre.y()),
          Vec2(centre.x(), 0.5 * (wide.minZ + below)), Vec2(centre.x(), 0.5 * (above + wide.maxZ))};
      for (std::size_t side = 0; side < kWalls; ++side) {
        if (overlaps[side] && link(i, centre, both[side], wall(side), wallPoint(side))) return true;
      }
    }
    return false;
  }

  bool joinRectangles() {
    const std::vector<Box>& boxes = plan_.boxes();
    std::vector<std::size_t> seenWith(boxes.size(), boxes.size());
    bool parted = false;
    for (std::size_t i = 0; i < boxes.size() && !parted; ++i) {
      plan_.grid().cellsOf(grown(boxes[i], reach_), [&](std::span<const std::uint32_t> candidates) {
        for (const std::uint32_t j : candidates) {
          if (j <= i || seenWith[j] == i) continue;
          seenWith[j] = i;
          if (distanceBetween(boxes[i], boxes[j]) >= 2.0 * reach_) continue;
          // Halfway between the nearest points, or the middle of the overlap.
          const Box& a = boxes[i];
          const Box& b = boxes[j];
          const Vec2 both(0.5 * (std::max(a.minX, b.minX) + std::min(a.maxX, b.maxX)),
                          0.5 * (std::max(a.minZ, b.minZ) + std::min(a.maxZ, b.maxZ)));
          parted = parted || link(i, centreOf(a), both, j, centreOf(b));
        }
      });
    }
    return parted;
  }

  const FloorPlan& plan_;
  double reach_;
  Vec2 from_;
  Vec2 to_;
  ParityUnion sets_;
};

}  // namespace

bool isConnected(const FloorPlan& plan, const Vec2& from, const Vec2& to) {
  return plan.isFree(from) && plan.isFree(to) && !Barrier(plan, from, to).parts();
}

}  // namespace stridegraph
