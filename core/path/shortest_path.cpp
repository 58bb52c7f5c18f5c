#include "path/shortest_path.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <utility>

#include "path/tangents.h"

namespace stridegraph {

namespace {

/// Arcs lie this far outside what FloorPlan calls touching, so that rounding never blocks a path at its own
/// corners.
constexpr double kArcSlackMetres = 1e-8;
constexpr double kDominanceSlackMetres = 1e-12;

/// A corner with a turn: where a path may bend. The goal is the place after the last.
using BendIndex = std::size_t;

/// A free tangent from a bend to another or to the goal.
struct Departure {
  double leaveRadians = 0.0;  ///< Along the quarter left.
  double lengthMetres = 0.0;
  double arriveRadians = 0.0;  ///< Along the quarter reached; 0 at the goal.
  Vec2 arrival = Vec2::Zero();
  BendIndex to = 0;
};

/// A path so far: it has just reached a bend by a tangent.
struct Arrival {
  BendIndex bend = 0;
  double radians = 0.0;       ///< Along the bend's quarter.
  double lengthMetres = 0.0;  ///< From the start.
  double parentLeaveRadians = 0.0;
  std::uint32_t parent = 0;
};

constexpr std::uint32_t kNoParent = std::numeric_limits<std::uint32_t>::max();

class TangentSearch {
 public:
  TangentSearch(const FloorPlan& plan, const Vec2& start, const Vec2& goal)
      : plan_(plan),
        start_(start),
        goal_(goal),
        radius_(plan.radiusMetres() - FloorPlan::kTouchToleranceMetres + kArcSlackMetres) {
    for (const Box& box : plan.boxes()) addCorners(box);
    departures_.resize(2 * corners_.size());
    known_.resize(2 * corners_.size(), false);
    expanded_.resize(2 * corners_.size());
  }

  std::optional<ShortestPath> run() {
    if (plan_.isFree(start_, goal_)) return ShortestPath{(goal_ - start_).norm(), {start_, goal_}};
    for (const Departure& departure : departuresFrom({start_, 0.0, Turn::kClockwise}, nullptr)) {
      push({departure.to, departure.arriveRadians, departure.lengthMetres, 0.0, kNoParent},
           departure.arrival);
    }
    while (!queue_.empty()) {
      const std::uint32_t index = pop();
      if (arrivals_[index].bend == goalBend()) return pathTo(index);
      if (!isDominated(arrivals_[index])) expand(index);
    }
    return std::nullopt;
  }

 private:
  struct QueueEntry {
    double estimateMetres;
    std::uint32_t arrival;
    bool operator>(const QueueEntry& other) const {
      return estimateMetres != other.estimateMetres ? estimateMetres > other.estimateMetres
                                                    : arrival > other.arrival;
    }
  };

  BendIndex goalBend() const { return 2 * corners_.size(); }
  static Turn turnOf(BendIndex bend) { return bend % 2 == 0 ? Turn::kClockwise : Turn::kCounterclockwise; }
  TangentCircle circleOf(BendIndex bend) const { return {corners_[bend / 2].centre, radius_, turnOf(bend)}; }
  Arc arcAt(BendIndex bend, double fromRadians, double toRadians) const {
    return {corners_[bend / 2], turnOf(bend), radius_, fromRadians, toRadians};
  }

  void addCorners(const Box& box) {
    const double margin = radius_ * 0.5;
    for (const double side : {-1.0, 1.0}) {
      for (const double end : {-1.0, 1.0}) {
        const Vec2 centre(side < 0.0 ? box.minX : box.maxX, end < 0.0 ? box.minZ : box.maxZ);
        const Corner corner{centre, {side, end}};
        const bool inRoom = centre.x() > -margin && centre.y() > -margin &&
                            centre.x() < plan_.widthMetres() + margin &&
                            centre.y() < plan_.depthMetres() + margin;
        if (inRoom) corners_.push_back(corner);
      }
    }
  }

  void push(const Arrival& arrival, const Vec2& point) {
    queue_.push_back(
        {arrival.lengthMetres + (goal_ - point).norm(), static_cast<std::uint32_t>(arrivals_.size())});
    std::push_heap(queue_.begin(), queue_.end(), std::greater<>());
    arrivals_.push_back(arrival);
  }

  std::uint32_t pop() {
    std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
    const std::uint32_t arrival = queue_.back().arrival;
    queue_.pop_back();
    return arrival;
  }

  /// Whether an earlier path passes the same place on the same arc and is no longer.
  bool isDominated(const Arrival& arrival) const {
    const std::vector<std::uint32_t>& others = expanded_[arrival.bend];
    return std::any_of(others.begin(), others.end(), [&](std::uint32_t index) {
      const Arrival& other = arrivals_[index];
      const double along = arrival.radians - other.radians;
      if (along < 0.0) return false;
      if (other.lengthMetres + radius_ * along > arrival.lengthMetres + kDominanceSlackMetres) return false;
      return canFollow(arrival.bend, other.radians, arrival.radians);
    });
  }

  bool canFollow(BendIndex bend, double fromRadians, double toRadians) const {
    std::vector<Vec2> points;
    return appendArc(plan_, arcAt(bend, fromRadians, toRadians), points);
  }

  /// All free tangents from a circle; those of a corner are in the order in which the turn meets them.
  std::vector<Departure> departuresFrom(const TangentCircle& circle, const Corner* corner) const {
    std::vector<Departure> found;
    const auto consider = [&](const TangentCircle& target, BendIndex to) {
      const std::optional<Tangent> tangent = tangentBetween(circle, target);
      if (!tangent) return;
      const Vec2 leaving = touchingNormal(*tangent, circle.turn);
      const Vec2 arriving = touchingNormal(*tangent, target.turn);
      if (corner != nullptr && !liesOnQuarter(*corner, leaving)) return;
      if (to != goalBend() && !liesOnQuarter(corners_[to / 2], arriving)) return;
      if (!plan_.isFree(tangent->from, tangent->to)) return;
      const double leave = corner == nullptr ? 0.0 : angleAlongQuarter(*corner, circle.turn, leaving);
      const double arrive =
          to == goalBend() ? 0.0 : angleAlongQuarter(corners_[to / 2], target.turn, arriving);
      found.push_back({leave, (tangent->to - tangent->from).norm(), arrive, tangent->to, to});
    };
    for (BendIndex bend = 0; bend < goalBend(); ++bend) consider(circleOf(bend), bend);
    consider({goal_, 0.0, Turn::kClockwise}, goalBend());
    std::stable_sort(found.begin(), found.end(),
                     [](const Departure& a, const Departure& b) { return a.leaveRadians < b.leaveRadians; });
    return found;
  }

  void expand(std::uint32_t index) {
    const Arrival arrival = arrivals_[index];
    const BendIndex bend = arrival.bend;
    expanded_[bend].push_back(index);
    if (!known_[bend]) {
      departures_[bend] = departuresFrom(circleOf(bend), &corners_[bend / 2]);
      known_[bend] = true;
    }
    double followed = arrival.radians;
    for (const Departure& departure : departures_[bend]) {
      if (departure.leaveRadians < arrival.radians - 1e-9) continue;
      const double leave = std::max(departure.leaveRadians, arrival.radians);
      if (!canFollow(bend, followed, leave)) return;
      followed = leave;
      const double length =
          arrival.lengthMetres + radius_ * (leave - arrival.radians) + departure.lengthMetres;
      push({departure.to, departure.arriveRadians, length, leave, index}, departure.arrival);
    }
  }

  ShortestPath pathTo(std::uint32_t last) const {
    std::vector<std::uint32_t> chain;
    for (std::uint32_t index = last; index != kNoParent; index = arrivals_[index].parent)
      chain.push_back(index);
    std::reverse(chain.begin(), chain.end());
    ShortestPath path{arrivals_[last].lengthMetres, {start_}};
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      const Arrival& here = arrivals_[chain[i]];
      const Arc arc = arcAt(here.bend, here.radians, arrivals_[chain[i + 1]].parentLeaveRadians);
      path.points.push_back(pointOnArc(arc, arc.fromRadians));
      appendArc(plan_, arc, path.points);
    }
    path.points.push_back(goal_);
    return path;
  }

  const FloorPlan& plan_;
  Vec2 start_;
  Vec2 goal_;
  double radius_;
  std::vector<Corner> corners_;
  std::vector<std::vector<Departure>> departures_;  ///< For each bend, once known.
  std::vector<bool> known_;
  std::vector<std::vector<std::uint32_t>> expanded_;  ///< For each bend, the arrivals expanded there.
  std::vector<Arrival> arrivals_;
  std::vector<QueueEntry> queue_;
};

}  // namespace

std::optional<ShortestPath> shortestPath(const FloorPlan& plan, const Vec2& start, const Vec2& goal) {
  if (!plan.isFree(start) || !plan.isFree(goal)) return std::nullopt;
  return TangentSearch(plan, start, goal).run();
}

}  // namespace stridegraph
