#include "walk/crowd.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <string>
#include <utility>

namespace stridegraph {
namespace {

/// A walker who is not planned yet is taken to stay where it is for so many frames.
constexpr std::uint32_t kUnplannedFrames = 30;

/// Orders of priority tried when a walker finds no way, or would be in another's at its goal.
constexpr std::size_t kOrders = 6;

/// Who walks is likely to be this fast on the whole.
constexpr double kLikelyMetresPerSecond = 1.3;

bool hasArrived(const Plan& plan) {
  return plan.report.status == PlanStatus::kArrived;
}

std::vector<Vec2> placesOf(const Plan& plan) {
  std::vector<Vec2> places;
  places.reserve(plan.way.size());
  for (const FloorTransform& placement : plan.way) places.push_back(placement.translation);
  return places;
}

}  // namespace

Crowd::Turn::Turn(const Crowd& crowd, std::size_t who, Traffic others)
    : walker(who),
      traffic(std::move(others)),
      task{crowd.floor_, crowd.walkers_[who].start, crowd.walkers_[who].goal, traffic, crowd.underWay(who),
           crowd.frame_, crowd.refusals_[who]},
      planning(crowd.prepared_, crowd.scene_, crowd.options_, task) {}

Crowd::Crowd(const Prepared& prepared, const Scene& scene, const PlanOptions& options,
             std::optional<Plan> current, std::size_t frame)
    : prepared_(prepared),
      scene_(scene),
      options_(options),
      floor_(scene_, options_.radiusMetres.value_or(scene_.radiusMetres)),
      current_(std::move(current)),
      frame_(frame),
      obstacles_(floor_.radiusMetres(), prepared_.library.frames.framesPerSecond) {
  for (std::size_t m = 0; m < scene_.moving.size(); ++m)
    obstacles_.addObstacle(scene_.moving[m], fmt::format("moving block {}", m + 1));
  walkers_.push_back({scene_.start, scene_.goal});
  walkers_.insert(walkers_.end(), scene_.walkers.begin(), scene_.walkers.end());
  std::vector<Beginner> beginners;
  for (std::size_t w = 0; w < walkers_.size(); ++w)
    beginners.push_back({walkers_[w], underWay(w) == nullptr});
  refusals_ = Overlaps{scene_, floor_.radiusMetres(), options_.goalRadiusMetres}.refusals(beginners);
  findFirst();
}

Plan Crowd::plan() const& {
  return joined(plans_);
}

Plan Crowd::plan() && {
  return joined(std::move(plans_));
}

Plan Crowd::joined(std::vector<Plan> plans) const {
  Plan first = std::move(plans.front());
  first.scene = scene_;
  first.options = options_;
  first.others.assign(std::make_move_iterator(plans.begin() + 1), std::make_move_iterator(plans.end()));
  return first;
}

bool Crowd::improve(std::uint64_t expansions) {
  bool better = false;
  while (canImprove() && expansions > 0) {
    Turn& turn = *turns_[turn_];
    const std::uint64_t before = turn.planning.expansions();
    if (turn.planning.improve(expansions)) {
      plans_[turn.walker] = turn.planning.plan();
      better = true;
    }
    expansions -= std::min(expansions, turn.planning.expansions() - before);
    if (turn.planning.canImprove()) continue;
    turn.planning.update(plans_[turn.walker].report);
    ++turn_;
    beginTurn();
  }
  return better;
}

double Crowd::progress() const {
  if (!canImprove()) return 1.0;
  return (static_cast<double>(turn_) + turns_[turn_]->planning.progress()) /
         static_cast<double>(turns_.size());
}

const Plan* Crowd::underWay(std::size_t walker) const {
  if (!current_) return nullptr;
  const Plan& plan = walker == 0 ? *current_ : current_->others[walker - 1];
  return hasArrived(plan) ? &plan : nullptr;
}

void Crowd::findFirst() {
  std::vector<std::size_t> order(walkers_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  wentFirst_.assign(walkers_.size(), false);
  std::vector<Plan> best;
  Turns bestTurns;
  std::size_t mostArrived = 0;
  const std::size_t attempts = std::min(kOrders, walkers_.size() + 1);
  for (std::size_t attempt = 0; attempt < attempts; ++attempt) {
    const std::optional<std::size_t> stuck = planInTurn(order, attempt < attempts / 2);
    const auto arrived = static_cast<std::size_t>(std::count_if(plans_.begin(), plans_.end(), hasArrived));
    if (!plans_.empty() && (best.empty() || arrived > mostArrived)) {
      mostArrived = arrived;
      best = std::move(plans_);
      bestTurns = std::move(turns_);
    }
    if (!stuck || *stuck == order.front()) break;
    order.erase(std::find(order.begin(), order.end(), *stuck));
    order.insert(order.begin(), *stuck);
    wentFirst_[*stuck] = true;
  }
  plans_ = std::move(best);
  turns_ = std::move(bestTurns);
  beginTurn();
}

/// Plans all in an order of priority; returns the first one whom others leave no way. Without any plans
/// where one had better go first, if that may be.
std::optional<std::size_t> Crowd::planInTurn(const std::vector<std::size_t>& order, bool mayGoFirst) {
  plans_.assign(walkers_.size(), {});
  turns_.clear();
  std::optional<std::size_t> stuck;
  for (std::size_t turn = 0; turn < order.size(); ++turn) {
    const std::size_t walker = order[turn];
    Traffic traffic = obstacles_;
    for (std::size_t other = 0; other < order.size(); ++other)
      if (other != turn) meet(order[other], other < turn, traffic);
    if (mayGoFirst && !wentFirst_[walker] && !refusals_[walker] && isInTheWay(walker, traffic)) {
      plans_.clear();
      return walker;
    }
    auto planned = std::make_unique<Turn>(*this, walker, std::move(traffic));
    plans_[walker] = planned->planning.plan();
    const PlanStatus status = plans_[walker].report.status;
    if (!stuck && (status == PlanStatus::kNoMotion || status == PlanStatus::kBudgetSpent)) stuck = walker;
    if (options_.improvementExpansions > 0) turns_.push_back(std::move(planned));
  }
  return stuck;
}

/// Whether others come over a walker's goal after it is likely to be there: they can go around who stands
/// there, but it would have to wait for them. Not where one of them stays there.
bool Crowd::isInTheWay(std::size_t walker, Traffic& traffic) const {
  const Walker& ends = walkers_[walker];
  const double seconds = (ends.goal.position - ends.start.position).norm() / kLikelyMetresPerSecond;
  const auto frames = static_cast<std::uint32_t>(seconds * prepared_.library.frames.framesPerSecond);
  return !traffic.staysClearOfBodies(ends.goal.position, frames) &&
         traffic.staysClearOfBodies(ends.goal.position, Traffic::kInTheEnd);
}

/// Adds another walker as what moves: its walk when it is planned, else where it is at first.
void Crowd::meet(std::size_t other, bool planned, Traffic& traffic) const {
  const std::array<Vec2, 1> start = {walkers_[other].start.position};
  const std::string name = fmt::format("walker {}", other + 1);
  if (planned && hasArrived(plans_[other])) {
    traffic.addBody(placesOf(plans_[other]), Traffic::kForEver, name);
  } else if (planned || (refusals_[other] && underWay(other) == nullptr)) {
    traffic.addBody(start, Traffic::kForEver, name);
  } else if (const Plan* walk = underWay(other)) {
    traffic.addBody(placesOf(*walk), static_cast<std::uint32_t>(frame_) + kUnplannedFrames, name);
  } else {
    traffic.addBody(start, kUnplannedFrames, name);
  }
}

/// Passes over those who have no better walk to look for, and lets the next one meet the walks of all others.
void Crowd::beginTurn() {
  while (canImprove() && !turns_[turn_]->planning.canImprove()) ++turn_;
  if (!canImprove()) return;
  Turn& turn = *turns_[turn_];
  Traffic traffic = obstacles_;
  for (std::size_t other = 0; other < walkers_.size(); ++other)
    if (other != turn.walker) meet(other, true, traffic);
  turn.traffic = std::move(traffic);
}

}  // namespace stridegraph
