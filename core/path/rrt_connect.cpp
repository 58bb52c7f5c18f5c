#include "path/rrt_connect.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "path/point_grid.h"

namespace stridegraph {

namespace {

enum class Growth { kTrapped, kAdvanced, kReached };

class Tree {
 public:
  Tree(const FloorPlan& plan, const Vec2& root, double stepMetres)
      : plan_(&plan), stepMetres_(stepMetres), nodes_({plan.widthMetres(), plan.depthMetres()}, stepMetres) {
    nodes_.add(root);
    parents_.push_back(0);
  }

  const std::vector<Vec2>& nodes() const { return nodes_.points(); }
  const Vec2& newest() const { return nodes_.points().back(); }

  /// One step from the nearest node towards the target.
  Growth extend(const Vec2& target) { return step(nodes_.nearest(target, 1).front(), target); }

  /// Steps towards the target until it is reached or something is in the way.
  Growth connect(const Vec2& target) {
    Growth growth = extend(target);
    while (growth == Growth::kAdvanced) {
      growth = step(static_cast<std::uint32_t>(nodes_.points().size() - 1), target);
    }
    return growth;
  }

  /// From the newest node back to the root.
  std::vector<Vec2> branch() const {
    std::vector<Vec2> points;
    auto node = static_cast<std::uint32_t>(nodes_.points().size() - 1);
    while (node != 0) {
      points.push_back(nodes_.points()[node]);
      node = parents_[node];
    }
    points.push_back(nodes_.points()[0]);
    return points;
  }

  void appendEdges(std::vector<std::pair<Vec2, Vec2>>& edges) const {
    for (std::size_t i = 1; i < parents_.size(); ++i) {
      edges.emplace_back(nodes_.points()[parents_[i]], nodes_.points()[i]);
    }
  }

 private:
  Growth step(std::uint32_t from, const Vec2& target) {
    const Vec2 origin = nodes_.points()[from];
    const Vec2 along = target - origin;
    const double metres = along.norm();
    const bool reaches = metres <= stepMetres_;
    const Vec2 next = reaches ? target : Vec2(origin + (stepMetres_ / metres) * along);
    if (!plan_->isFree(origin, next)) return Growth::kTrapped;
    nodes_.add(next);
    parents_.push_back(from);
    return reaches ? Growth::kReached : Growth::kAdvanced;
  }

  const FloorPlan* plan_;
  double stepMetres_;
  PointGrid nodes_;
  std::vector<std::uint32_t> parents_;
};

/// A free place for the tree to grow to: by turns anywhere in the room and near one of its nodes. In a large
/// room full of obstacles the first kind alone keeps asking the same few nodes at the tree's rim, which stand
/// before an obstacle and cannot move.
std::optional<Vec2> sampleFor(const FloorPlan& plan, const Tree& tree, double stepMetres, bool nearby,
                              Random& random) {
  if (!nearby) return sampleFree(plan, random);
  constexpr double kReachSteps = 5.0;
  constexpr int kTries = 20;
  const Vec2 node = tree.nodes()[random.below(tree.nodes().size())];
  for (int i = 0; i < kTries; ++i) {
    const double x = node.x() + random.uniform(-kReachSteps, kReachSteps) * stepMetres;
    const Vec2 point(x, node.y() + random.uniform(-kReachSteps, kReachSteps) * stepMetres);
    if (plan.isFree(point)) return point;
  }
  return sampleFree(plan, random);
}

double stepFor(const FloorPlan& plan, double asked) {
  constexpr double kStepsAcrossRoom = 30.0;
  if (asked > 0.0) return std::clamp(asked, 0.05, 100.0);
  return std::max(1.0, std::sqrt(plan.widthMetres() * plan.depthMetres()) / kStepsAcrossRoom);
}

std::vector<Vec2> joined(const Tree& fromStart, const Tree& fromGoal) {
  std::vector<Vec2> path = fromStart.branch();
  std::reverse(path.begin(), path.end());
  const std::vector<Vec2> rest = fromGoal.branch();
  path.insert(path.end(), rest.begin(), rest.end());
  return path;
}

}  // namespace

SampledPath planByTrees(const FloorPlan& plan, const Vec2& start, const Vec2& goal, Random& random,
                        const PathParams& params) {
  const double step = stepFor(plan, params.stepMetres);
  Tree fromStart(plan, start, step);
  Tree fromGoal(plan, goal, step);
  Tree* growing = &fromStart;
  Tree* other = &fromGoal;
  SampledPath result;
  const std::size_t samples = std::clamp<std::size_t>(params.treeSamples, 1, 1'000'000);
  if (fromStart.connect(goal) == Growth::kReached) result.path = joined(fromStart, fromGoal);
  for (std::size_t i = 0; i < samples && result.path.empty(); ++i) {
    // Each tree grows at every second sample, so that bit 1 gives both kinds of samples to both.
    const std::optional<Vec2> sample = sampleFor(plan, *growing, step, (i & 2U) != 0, random);
    if (!sample) break;
    if (growing->extend(*sample) != Growth::kTrapped &&
        other->connect(growing->newest()) == Growth::kReached) {
      result.path = joined(fromStart, fromGoal);
    }
    std::swap(growing, other);
  }
  fromStart.appendEdges(result.edges);
  fromGoal.appendEdges(result.edges);
  return result;
}

}  // namespace stridegraph
