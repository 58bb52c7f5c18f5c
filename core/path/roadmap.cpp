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

/// A part of few nodes needs few more; one of half the roadmap doubles it.
constexpr std::size_t kNewNodesPerWantingNode = 5;
constexpr std::size_t kLeastNewNodes = 20;

using NodePair = std::pair<std::uint32_t, std::uint32_t>;

struct Neighbour {
  std::uint32_t node;
  double metres;
};

std::size_t nodeCount(const FloorPlan& plan, std::size_t asked) {
  if (asked > 0) return std::clamp<std::size_t>(asked, 10, 100'000);
  const double count = plan.widthMetres() * plan.depthMetres() / kSquareMetresPerNode;
  return static_cast<std::size_t>(std::clamp(count, 200.0, 10'000.0));
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

/// The nodes joined to an end, that end among them, in the order in which they are met.
std::vector<std::uint32_t> joinedTo(std::uint32_t end, const std::vector<std::vector<Neighbour>>& lists) {
  std::vector<bool> met(lists.size(), false);
  std::vector<std::uint32_t> nodes = {end};
  met[end] = true;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const Neighbour& neighbour : lists[nodes[i]]) {
      if (met[neighbour.node]) continue;
      met[neighbour.node] = true;
      nodes.push_back(neighbour.node);
    }
  }
  return nodes;
}

/// Adds nodes up to a count: anywhere, or by turns near one of the `wanting` nodes, where the roadmap needs
/// them (the expansion step of Kavraki et al. 1996).
void addNodes(const FloorPlan& plan, std::size_t count, const std::vector<std::uint32_t>& wanting,
              PointGrid& nodes, Random& random) {
  constexpr double kNearMetres = 3.0;
  while (nodes.points().size() < count) {
    const bool nearby = !wanting.empty() && nodes.points().size() % 2 == 0;
    std::optional<Vec2> node;
    if (nearby) {
      const Vec2 around = nodes.points()[wanting[random.below(wanting.size())]];
      const double x = around.x() + random.uniform(-kNearMetres, kNearMetres);
      const Vec2 point(x, around.y() + random.uniform(-kNearMetres, kNearMetres));
      if (plan.isFree(point)) node = point;
    }
    if (!node) node = sampleFree(plan, random);
    if (!node) return;
    nodes.add(*node);
  }
}

/// Dijkstra 1959; the points from start to goal, empty when they are not joined.
std::vector<Vec2> shortestInRoadmap(const std::vector<Vec2>& points,
                                    const std::vector<std::vector<Neighbour>>& lists) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
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
  std::vector<std::uint32_t> wanting;
  for (int round = 0; round <= std::clamp(params.growths, 0, 20); ++round) {
    addNodes(plan, count + 2, wanting, nodes, random);
    const std::vector<NodePair> pairs = connect(plan, nodes, neighbours);
    result.edges.clear();
    for (const auto& [a, b] : pairs) result.edges.emplace_back(nodes.points()[a], nodes.points()[b]);
    const std::vector<std::vector<Neighbour>> lists = neighbourLists(nodes.points(), pairs);
    result.path = shortestInRoadmap(nodes.points(), lists);
    if (!result.path.empty()) break;
    wanting = joinedTo(kStart, lists);
    std::vector<std::uint32_t> aroundGoal = joinedTo(kGoal, lists);
    if (aroundGoal.size() < wanting.size()) wanting = std::move(aroundGoal);
    count += std::min(count, 2 * (kNewNodesPerWantingNode * wanting.size() + kLeastNewNodes));
  }
  return result;
}

}  // namespace stridegraph
