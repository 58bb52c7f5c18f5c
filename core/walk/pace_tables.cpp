#include "walk/pace_tables.h"

#include <algorithm>
#include <limits>

#include "walk/constraint_cost.h"
#include "walk/search_heap.h"
#include "walk/walk_cost.h"

namespace stridegraph {
namespace {

/// A walk in no hurry goes about so fast: the preferred speed of adults (Bohannon 1997).
constexpr double kUnhurriedMetresPerSecond = 1.3;

/// Who is to be found fastest pays this much for a second, metres, beside the way's length.
constexpr double kHurryPerSecond = 10.0;

/// Over less than this getting going only to stop again need not be the soonest.
constexpr double kWorthGoingMetres = 6.0;

/// A body that needs no more than this to go on straight is going well, metres of cost.
constexpr double kGoingWellMetres = 0.2;

/// The cheapest ways to a stand, from every node.
struct Stands {
  std::vector<double> cost;
  std::vector<double> metres;  ///< Length of that way.
};

/// Dijkstra's algorithm backwards from all stands.
template <typename CostOf>
Stands standsOf(const SearchGraph& graph, const CostOf& costOf) {
  Stands stands;
  stands.cost.assign(graph.nodeCount(), std::numeric_limits<double>::infinity());
  stands.metres.assign(graph.nodeCount(), 0.0);
  SearchHeap heap;
  std::vector<std::uint32_t> nodes;
  const auto reach = [&](std::uint32_t node, double cost, double metres) {
    if (cost >= stands.cost[node]) return;
    stands.cost[node] = cost;
    stands.metres[node] = metres;
    heap.push(cost, static_cast<std::uint32_t>(nodes.size()));
    nodes.push_back(node);
  };
  for (const SearchEdge& edge : graph.edges()) {
    if (edge.settledSample == SearchEdge::kNone) continue;
    const double share = edge.settledShare();
    reach(edge.from, share * costOf(edge), share * edge.lengthMetres);
  }
  while (!heap.empty()) {
    const std::uint32_t to = nodes[heap.pop()];
    for (const std::uint32_t index : graph.edgesInto(to)) {
      const SearchEdge& edge = graph.edges()[index];
      reach(edge.from, costOf(edge) + stands.cost[to], edge.lengthMetres + stands.metres[to]);
    }
  }
  return stands;
}

/// What coming to a stand takes at least beyond its metres at a table's cost and a price for each, for a body
/// that is going well.
double leastStop(const Stands& stands, const SteeringTable& steering, double perMetre) {
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t node = 0; node < stands.cost.size(); ++node) {
    if (steering.extraMetres(node, {}) > kGoingWellMetres) continue;
    least = std::min(least, stands.cost[node] - (steering.costPerMetre() + perMetre) * stands.metres[node]);
  }
  return std::isfinite(least) ? std::max(least, 0.0) : 0.0;
}

}  // namespace

double Hurry::secondsTo(std::uint32_t node, double metres, bool standing) const {
  const double seconds = secondsPerMetre * metres;
  if (metres < kWorthGoingMetres) return seconds;
  return seconds + goingSeconds[node] + (standing ? stopSeconds : 0.0);
}

std::shared_ptr<const PaceTable> PaceTables::of(const WalkConstraints& wishes) {
  WalkConstraints pace;
  pace.gait = wishes.gait;
  pace.minSpeedMetresPerSecond = wishes.minSpeedMetresPerSecond;
  pace.maxSpeedMetresPerSecond = wishes.maxSpeedMetresPerSecond;
  const auto known =
      std::find_if(kept_.begin(), kept_.end(), [&](const Kept& kept) { return kept.wishes == pace; });
  if (known != kept_.end()) return known->table;
  if (kept_.size() == kMost) kept_.erase(kept_.begin());
  kept_.push_back({pace, make(pace)});
  return kept_.back().table;
}

std::shared_ptr<const Hurry> PaceTables::hurry() {
  if (!hurry_) hurry_ = makeHurry();
  return hurry_;
}

std::shared_ptr<const Hurry> PaceTables::makeHurry() const {
  WalkCost cost;
  cost.perSecond = kHurryPerSecond;
  cost.perRadian = cost.perStrain = cost.perTransition = cost.perTransitionMetre = 0.0;
  const SteeringTable steering(graph_, cost, framesPerSecond_);
  const Stands stands =
      standsOf(graph_, [&](const SearchEdge& way) { return cost.ofGoing(way, framesPerSecond_); });
  Hurry hurry;
  hurry.secondsPerMetre = (steering.costPerMetre() - 1.0) / kHurryPerSecond;
  hurry.stopSeconds = leastStop(stands, steering, 0.0) / kHurryPerSecond;
  for (std::uint32_t node = 0; node < graph_.nodeCount(); ++node) {
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t sector = 0; sector < SteeringTable::kSectors; ++sector) {
      const Angle angle = Angle::degrees(360.0 * sector / SteeringTable::kSectors);
      least = std::min(least, steering.extraMetres(node, Heading::fromAngle(angle)));
    }
    hurry.goingSeconds.push_back(least / kHurryPerSecond);
  }
  return std::make_shared<const Hurry>(std::move(hurry));
}

std::shared_ptr<const PaceTable> PaceTables::make(const WalkConstraints& pace) const {
  const ConstraintCost wishes(pace, framesPerSecond_);
  const WalkCost cost;
  const auto more = [&](const SearchEdge& way) { return wishes.ofPace(way); };
  PaceTable table{SteeringTable(graph_, cost, framesPerSecond_, more), {}};
  Stands stands =
      standsOf(graph_, [&](const SearchEdge& way) { return cost.ofWay(way, framesPerSecond_) + more(way); });
  table.stopMetres = leastStop(stands, table.steering, 0.0);
  table.unhurriedPerMetre = wishes.perSecondAt(kUnhurriedMetresPerSecond) / kUnhurriedMetresPerSecond;
  // Where no clip keeps the pace, the cheapest walk is the only one.
  const bool only = table.steering.costPerMetre() > usual_.costPerMetre() + table.unhurriedPerMetre;
  table.unhurriedStopMetres =
      only ? std::numeric_limits<double>::infinity() : leastStop(stands, usual_, table.unhurriedPerMetre);
  table.standMetres = std::move(stands.cost);
  return std::make_shared<const PaceTable>(std::move(table));
}

}  // namespace stridegraph
