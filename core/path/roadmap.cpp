#include "path/roadmap.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>

#include "path/point_grid.h"

namespace stridegraph {

namespace {

constexpr std::uint32_t kStart = 0;
constexpr std::uint32_t kGoal = 1;
constexpr double kSquareMetresPerNode = 4.0;
/// Of these many nearest nodes, start and goal look for visible ones.
constexpr std::size_t kNodesLookedAtByEnds = 100;

using NodePair = std::pair<std::uint32_t, std::uint32_t>;

struct Neighbour {
  std::uint32_t node;
  double metres;
};

std::size_t nodeCount(const FloorPlan& plan, std::size_t asked) {
  if (asked > 0) return std::clamp<std::size_t>(asked, 10, 100'000);
  const double count = plan.widthMetres() * plan.depthMetres() / kSquareMetresPerNode;
  return static_cast<std::size_t>(std::clamp(count, 200.0, 4000.0));
}

/// Pairs of nodes that see each other, each once, in a fixed order.
std::vector<NodePair> connect(const FloorPlan& plan, const PointGrid& nodes, std::size_t neighbours) {
  std::vector<NodePair> pairs;
  const auto count = static_cast<std::uint32_t>(nodes.points().size());
  for (std::uint32_t node = 0; node < count; ++node) {
    const bool isEnd = node == kStart || node == kGoal;
    std::size_t seen = 0;
    for (const std::uint32_t other :
         nodes.nearest(nodes.points()[node], isEnd ? kNodesLookedAtByEnds : neighbours + 1)) {
      if (other == node) continue;
      if (isEnd && seen == neighbours) break;
      if (isEnd && !plan.isFree(nodes.points()[node], nodes.points()[other])) continue;
      ++seen;
      pairs.emplace_back(std::min(node, other), std::max(node, other));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  const auto isBlocked = [&](const NodePair& pair) {
    return !plan.isFree(nodes.points()[pair.first], nodes.points()[pair.second]);
  };
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(), isBlocked), pairs.end());
  return pairs;
}

std::vector<std::vector<Neighbour>> neighbourLists(const std::vector<Vec2>& points,
                                                   const std::vector<NodePair>& pairs) {
  std::vector<std::vector<Neighbour>> lists(points.size());
  for (const auto& [a, b] : pairs) {
    const double metres = (points[a] - points[b]).norm();
    lists[a].push_back({b, metres});
    lists[b].push_back({a, metres});
  }
  return lists;
}

/// Dijkstra 1959; the points from start to goal, empty when they are not joined.
std::vector<Vec2> shortestInRoadmap(const std::vector<Vec2>& points, const std::vector<NodePair>& pairs) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  const std::vector<std::vector<Neighbour>> lists = neighbourLists(points, pairs);
  std::vector<double> metres(points.size(), std::numeric_limits<double>::infinity());
  std::vector<std::uint32_t> parents(points.size(), kNone);
  std::vector<std::pair<double, std::uint32_t>> heap = {{0.0, kStart}};
  metres[kStart] = 0.0;
  while (!heap.empty()) {
    std::pop_heap(heap.begin(), heap.end(), std::greater<>());
    const auto [length, node] = heap.back();
    heap.pop_back();
    if (length > metres[node]) continue;
    if (node == kGoal) break;
    for (const Neighbour& neighbour : lists[node]) {
      const double through = length + neighbour.metres;
      if (through >= metres[neighbour.node]) continue;
      metres[neighbour.node] = through;
      parents[neighbour.node] = node;
      heap.emplace_back(through, neighbour.node);
      std::push_heap(heap.begin(), heap.end(), std::greater<>());
    }
  }
  if (parents[kGoal] == kNone) return {};
  std::vector<Vec2> path;
  for (std::uint32_t node = kGoal; node != kNone; node = parents[node]) path.push_back(points[node]);
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace

SampledPath planByRoadmap(const FloorPlan& plan, const Vec2& start, const Vec2& goal, Random& random,
                          const PathParams& params) {
  std::size_t count = nodeCount(plan, params.roadmapNodes);
  const Vec2 roomSize(plan.widthMetres(), plan.depthMetres());
  const double area = plan.widthMetres() * plan.depthMetres();
  PointGrid nodes(roomSize, std::sqrt(2.0 * area / static_cast<double>(count)));
  nodes.add(start);
  nodes.add(goal);
  const std::size_t neighbours = std::clamp<std::size_t>(params.neighbours, 1, 100);
  SampledPath result;
  for (int round = 0; round <= std::clamp(params.doublings, 0, 8); ++round, count *= 2) {
    while (nodes.points().size() < count + 2) {
      const std::optional<Vec2> node = sampleFree(plan, random);
      if (!node) break;
      nodes.add(*node);
    }
    const std::vector<NodePair> pairs = connect(plan, nodes, neighbours);
    result.edges.clear();
    for (const auto& [a, b] : pairs) result.edges.emplace_back(nodes.points()[a], nodes.points()[b]);
    result.path = shortestInRoadmap(nodes.points(), pairs);
    if (!result.path.empty()) break;
  }
  return result;
}

}  // namespace stridegraph
