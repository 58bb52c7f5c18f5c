#include "path/roadmap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <span>

#include "path/point_grid.h"

namespace stridegraph {

namespace {

constexpr std::uint32_t kStart = 0;
constexpr std::uint32_t kGoal = 1;
constexpr double kSquareMetresPerNode = 0.4;
/// Start and goal look for so many visible nodes among so many nearest.
constexpr std::size_t kNodesSeenByEnds = 10;
constexpr std::size_t kNodesLookedAtByEnds = 100;

/// A part of few nodes needs few more; one of half the roadmap doubles it.
constexpr std::size_t kNewNodesPerWantingNode = 5;
constexpr std::size_t kLeastNewNodes = 20;

std::size_t nodeCount(const FloorPlan& plan, std::size_t asked) {
  if (asked > 0) return std::clamp<std::size_t>(asked, 10, 100'000);
  const double count = plan.widthMetres() * plan.depthMetres() / kSquareMetresPerNode;
  return static_cast<std::size_t>(std::clamp(count, 500.0, 100'000.0));
}

/// Adds nodes up to a count: anywhere, or near the `wanting` nodes, where the roadmap needs them (the
/// expansion step of Kavraki et al. 1996): by turns, or only there where they are few.
void addNodes(const FloorPlan& plan, std::size_t count, const std::vector<std::uint32_t>& wanting,
              PointGrid& nodes, Random& random) {
  constexpr double kNearMetres = 3.0;
  const bool few = 10 * wanting.size() < nodes.points().size();
  while (nodes.points().size() < count) {
    const bool nearby = !wanting.empty() && (few || nodes.points().size() % 2 == 0);
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

/// Draws places around a way's cells, closer ones more often, and adds those that are free.
void addNodesAlong(const FloorPlan& plan, std::span<const Vec2> way, std::size_t count, PointGrid& nodes,
                   Random& random) {
  constexpr double kFarthestMetres = 1.5;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 around = way[random.below(way.size())];
    const double share = random.uniform();
    const double reach = kFarthestMetres * share * share;
    const double x = around.x() + random.uniform(-reach, reach);
    const Vec2 point(x, around.y() + random.uniform(-reach, reach));
    if (plan.isFree(point)) nodes.add(point);
  }
}

/// The stretch of a way around the place where a search along it came to a halt: as near to the goal as any
/// of the nodes that it met.
std::span<const Vec2> stretchAround(const DistanceField& field, const PointGrid& nodes,
                                    std::span<const std::uint32_t> met, std::span<const Vec2> way) {
  constexpr double kStretchMetres = 2.0;
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::uint32_t node : met) nearest = std::min(nearest, field.metresToGoal(nodes.points()[node]));
  const auto halt = std::lower_bound(way.begin(), way.end(), nearest, [&](const Vec2& cell, double metres) {
    return field.metresToGoal(cell) > metres;
  });
  const auto reach = static_cast<std::ptrdiff_t>(std::ceil(kStretchMetres / field.cellMetres()));
  const auto first = way.begin() + std::max<std::ptrdiff_t>(0, halt - way.begin() - reach);
  const auto last = halt + std::min<std::ptrdiff_t>(reach, way.end() - halt);
  return {first, last};
}

/// The roadmap as it is looked at: neighbours of a node, and whether they see each other, are only found out
/// where the search for the shortest way comes by (lazy PRM, Bohlin and Kavraki 2000).
class LazyRoadmap {
 public:
  /// Nodes nearer than `reachMetres` to each other are neighbours. With a field, its distances lead the
  /// search; else straight lines do.
  LazyRoadmap(const FloorPlan& plan, const PointGrid& nodes, double reachMetres,
              const DistanceField* field = nullptr)
      : plan_(plan),
        nodes_(nodes),
        reachMetres_(reachMetres),
        field_(field),
        metres_(count(), kFar),
        parents_(count(), kNone) {
    for (const std::uint32_t end : {kStart, kGoal}) nearEnds_[end] = visibleFrom(end);
  }

  /// Weighted A*; the points from start to goal, empty when they are not joined.
  std::vector<Vec2> shortest() {
    expandAll(kStart, kGoal, count());
    if (parents_[kGoal] == kNone) return {};
    std::vector<Vec2> path;
    for (std::uint32_t node = kGoal; node != kNone; node = parents_[node]) path.push_back(at(node));
    std::reverse(path.begin(), path.end());
    return path;
  }

  /// After shortest() found none: the nodes joined to the start.
  const std::vector<std::uint32_t>& met() const { return met_; }

  /// Nodes joined to one end, in the order in which they are met; at most `most`. Not after shortest().
  std::vector<std::uint32_t> joinedTo(std::uint32_t end, std::size_t most) {
    expandAll(end, kNone, most);
    return std::move(met_);
  }

  /// Pairs of nodes found to see each other, each once.
  std::vector<std::pair<Vec2, Vec2>> edges() const {
    std::vector<NodePair> pairs = seen_;
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    std::vector<std::pair<Vec2, Vec2>> edges;
    for (const auto& [a, b] : pairs) edges.emplace_back(at(a), at(b));
    return edges;
  }

 private:
  using NodePair = std::pair<std::uint32_t, std::uint32_t>;
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  /// Of the heuristic (Pohl 1970): a third of the nodes looked at for 0.1 % more length.
  static constexpr double kWeight = 1.15;
  static constexpr double kFar = std::numeric_limits<double>::infinity();

  std::size_t count() const { return nodes_.points().size(); }
  const Vec2& at(std::uint32_t node) const { return nodes_.points()[node]; }

  /// The nearest nodes that an end sees.
  std::vector<std::uint32_t> visibleFrom(std::uint32_t end) const {
    std::vector<std::uint32_t> visible;
    for (const std::uint32_t other : nodes_.nearest(at(end), kNodesLookedAtByEnds)) {
      if (visible.size() == kNodesSeenByEnds) break;
      if (other != end && plan_.isFree(at(end), at(other))) visible.push_back(other);
    }
    return visible;
  }

  template <typename Visit>
  void visitNeighbours(std::uint32_t node, const Visit& visit) const {
    if (node == kStart || node == kGoal) {
      for (const std::uint32_t near : nearEnds_[node]) visit(near);
      return;
    }
    nodes_.visitWithin(at(node), reachMetres_, visit);
    for (const std::uint32_t end : {kStart, kGoal}) {
      const std::vector<std::uint32_t>& ofEnd = nearEnds_[end];
      if (std::find(ofEnd.begin(), ofEnd.end(), node) != ofEnd.end()) visit(end);
    }
  }

  /// From one node to another, or to the nearest `most` that are joined to it.
  void expandAll(std::uint32_t from, std::uint32_t to, std::size_t most) {
    const auto toGo = [&](std::uint32_t node) {
      if (to == kNone) return 0.0;
      return kWeight * (field_ != nullptr ? field_->metresToGoal(at(node)) : (at(node) - at(to)).norm());
    };
    std::vector<bool> done(count(), false);
    std::vector<std::pair<double, std::uint32_t>> heap = {{toGo(from), from}};
    metres_[from] = 0.0;
    met_.clear();
    while (!heap.empty() && met_.size() < most) {
      std::pop_heap(heap.begin(), heap.end(), std::greater<>());
      const std::uint32_t node = heap.back().second;
      heap.pop_back();
      if (done[node]) continue;
      done[node] = true;
      met_.push_back(node);
      if (node == to) return;
      visitNeighbours(node, [&](std::uint32_t next) {
        const double through = metres_[node] + (at(next) - at(node)).norm();
        if (through >= metres_[next] || !plan_.isFree(at(node), at(next))) return;
        seen_.emplace_back(std::min(node, next), std::max(node, next));
        metres_[next] = through;
        parents_[next] = node;
        heap.emplace_back(through + toGo(next), next);
        std::push_heap(heap.begin(), heap.end(), std::greater<>());
      });
    }
  }

  const FloorPlan& plan_;
  const PointGrid& nodes_;
  double reachMetres_;
  const DistanceField* field_;
  std::array<std::vector<std::uint32_t>, 2> nearEnds_;
  std::vector<double> metres_;
  std::vector<std::uint32_t> parents_;
  std::vector<std::uint32_t> met_;
  std::vector<NodePair> seen_;
};

/// A roadmap that grows until it holds the way.
class GrowingRoadmap {
 public:
  GrowingRoadmap(const FloorPlan& plan, const Vec2& start, const Vec2& goal, Random& random,
                 const PathParams& params)
      : plan_(plan),
        random_(random),
        params_(params),
        area_(plan.widthMetres() * plan.depthMetres()),
        count_(nodeCount(plan, params.roadmapNodes)),
        nodes_({plan.widthMetres(), plan.depthMetres()},
               std::sqrt(2.0 * area_ / static_cast<double>(count_))) {
    nodes_.add(start);
    nodes_.add(goal);
  }

  SampledPath run() {
    SampledPath result;
    for (int round = 0; round <= std::clamp(params_.growths, 0, 20); ++round) {
      addNodes(plan_, count_ + 2, pocket_, nodes_, random_);
      if (round == 0 || isOutOfPocket()) {
        LazyRoadmap roadmap(plan_, nodes_, reachMetres());
        result.path = roadmap.shortest();
        result.edges = roadmap.edges();
        if (!result.path.empty()) break;
        findPocket(roadmap.met());
      }
      count_ += std::min(count_, 2 * (kNewNodesPerWantingNode * pocket_.size() + kLeastNewNodes));
    }
    return result;
  }

 private:
  /// So many nodes lie on average in a circle of that radius.
  double reachMetres() const {
    const auto neighbours = static_cast<double>(std::clamp<std::size_t>(params_.neighbours, 1, 100));
    return std::sqrt(neighbours * area_ / (std::numbers::pi * static_cast<double>(count_)));
  }

  /// The smaller of the parts that hold start and goal, when neither holds both.
  void findPocket(std::vector<std::uint32_t> aroundStart) {
    pocket_ = LazyRoadmap(plan_, nodes_, reachMetres()).joinedTo(kGoal, aroundStart.size());
    pocketEnd_ = kGoal;
    if (pocket_.size() < aroundStart.size()) return;
    pocket_ = std::move(aroundStart);
    pocketEnd_ = kStart;
  }

  /// Whether the part that was small now reaches the other end or is several times as large: only then a
  /// search of all is worth its while.
  bool isOutOfPocket() {
    const std::size_t many = kLeastNewNodes + kNewNodesPerWantingNode * pocket_.size();
    pocket_ = LazyRoadmap(plan_, nodes_, reachMetres()).joinedTo(pocketEnd_, many);
    const std::uint32_t other = pocketEnd_ == kStart ? kGoal : kStart;
    return pocket_.size() == many || std::find(pocket_.begin(), pocket_.end(), other) != pocket_.end();
  }

  const FloorPlan& plan_;
  Random& random_;
  const PathParams& params_;
  double area_;
  std::size_t count_;
  PointGrid nodes_;
  std::vector<std::uint32_t> pocket_;  ///< Nodes around an end that they do not lead away from.
  std::uint32_t pocketEnd_ = kStart;
};

}  // namespace

SampledPath planAlongField(const FloorPlan& plan, const Vec2& start, const DistanceField& field,
                           Random& random) {
  constexpr double kNodesPerMetre = 14.0;
  constexpr double kLeastNodes = 100.0;
  constexpr std::size_t kNodesWhereItHalts = 40;
  constexpr double kReachMetres = 1.5;
  constexpr int kRounds = 20;
  const std::vector<Vec2> way = field.cellsToGoal(start);
  if (way.empty()) return {};
  PointGrid nodes({plan.widthMetres(), plan.depthMetres()}, kReachMetres);
  nodes.add(start);
  nodes.add(field.goal());
  const double count = kNodesPerMetre * static_cast<double>(way.size()) * field.cellMetres();
  addNodesAlong(plan, way, static_cast<std::size_t>(std::max(kLeastNodes, count)), nodes, random);
  SampledPath result;
  for (int round = 0; round < kRounds; ++round) {
    LazyRoadmap roadmap(plan, nodes, kReachMetres, &field);
    result.path = roadmap.shortest();
    result.edges = roadmap.edges();
    if (!result.path.empty()) break;
    addNodesAlong(plan, stretchAround(field, nodes, roadmap.met(), way), kNodesWhereItHalts, nodes, random);
  }
  return result;
}

SampledPath planByRoadmap(const FloorPlan& plan, const Vec2& start, const Vec2& goal, Random& random,
                          const PathParams& params) {
  return GrowingRoadmap(plan, start, goal, random, params).run();
}

}  // namespace stridegraph
