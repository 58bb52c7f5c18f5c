#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "scene/scene_json.h"
#include "walk/keeping.h"
#include "walk/plan.h"
#include "walk/planning.h"

namespace stridegraph {
namespace {

Result<void> checkRange(std::string_view name, double value, double low, double high) {
  if (value >= low && value <= high) return {};
  return fail(ErrorCode::kInvalidArgument,
              fmt::format("{}: found {}, expected {} to {}", name, value, low, high));
}

Result<void> checkOptions(const PlanOptions& options) {
  if (options.radiusMetres) {
    if (auto checked = checkRange("radius", *options.radiusMetres, 0.05, 5.0); !checked) return checked;
  }
  if (options.enoughRatio) {
    if (auto checked = checkRange("until", *options.enoughRatio, 1.0, 10.0); !checked) return checked;
  }
  if (auto checked = checkRange("goal radius", options.goalRadiusMetres, 0.01, 5.0); !checked) return checked;
  if (auto checked = checkRange("subgoal spacing", options.subgoalSpacingMetres, 0.2, 20.0); !checked)
    return checked;
  return checkRange("budget in milliseconds", options.budgetMilliseconds, 0.0, 1e9);
}

/// A walker who is not planned yet is taken to stay where it is for so many frames.
constexpr std::uint32_t kUnplannedFrames = 30;

/// Orders of priority tried when a walker finds no way, or would be in another's at its goal.
constexpr std::size_t kOrders = 6;

/// Who walks is likely to be this fast on the whole.
constexpr double kLikelyMetresPerSecond = 1.3;

/// A walk that still holds is left for another only where that saves this share of what is left to go.
constexpr double kWorthTurning = 0.03;

/// The walk as it is, in another scene.
Plan keptIn(const Scene& scene, Plan walk) {
  walk.scene = scene;
  walk.kept = true;
  return walk;
}

FloorPlan floorOf(const Scene& scene, const PlanOptions& options) {
  return FloorPlan(scene, options.radiusMetres.value_or(scene.radiusMetres));
}

std::vector<Vec2> placesOf(const Plan& plan) {
  std::vector<Vec2> places;
  places.reserve(plan.way.size());
  for (const FloorTransform& placement : plan.way) places.push_back(placement.translation);
  return places;
}

/// All walkers of a scene, one after the other.
class Crowd {
 public:
  Crowd(const Prepared& prepared, const Scene& scene, const FloorPlan& floor, const PlanOptions& options)
      : prepared_(prepared),
        scene_(scene),
        floor_(floor),
        options_(options),
        obstacles_(floor.radiusMetres(), prepared.library.frames.framesPerSecond) {
    for (const MovingObstacle& obstacle : scene.moving) obstacles_.addObstacle(obstacle);
    walkers_.push_back({scene.start, scene.goal});
    walkers_.insert(walkers_.end(), scene.walkers.begin(), scene.walkers.end());
  }

  /// Walks begin anew, or go on from a frame of `current`.
  Plan run(const Plan* current = nullptr, std::size_t frame = 0) {
    current_ = current;
    frame_ = frame;
    std::vector<std::size_t> order(walkers_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    wentFirst_.assign(walkers_.size(), false);
    std::vector<Plan> best;
    std::size_t mostArrived = 0;
    const std::size_t attempts = std::min(kOrders, walkers_.size() + 1);
    for (std::size_t attempt = 0; attempt < attempts; ++attempt) {
      const std::optional<std::size_t> stuck = planInTurn(order, attempt < attempts / 2);
      const auto arrived = static_cast<std::size_t>(
          std::count_if(plans_.begin(), plans_.end(), [](const Plan& plan) { return hasArrived(plan); }));
      if (!plans_.empty() && (best.empty() || arrived > mostArrived)) {
        mostArrived = arrived;
        best = std::move(plans_);
      }
      if (!stuck || *stuck == order.front()) break;
      order.erase(std::find(order.begin(), order.end(), *stuck));
      order.insert(order.begin(), *stuck);
      wentFirst_[*stuck] = true;
    }
    Plan first = std::move(best.front());
    first.scene = scene_;
    first.options = options_;
    first.others.assign(std::make_move_iterator(best.begin() + 1), std::make_move_iterator(best.end()));
    return first;
  }

 private:
  static bool hasArrived(const Plan& plan) { return plan.report.status == PlanStatus::kArrived; }

  const Plan* underWay(std::size_t walker) const {
    if (current_ == nullptr) return nullptr;
    const Plan& plan = walker == 0 ? *current_ : current_->others[walker - 1];
    return hasArrived(plan) ? &plan : nullptr;
  }

  /// Plans all in an order of priority; returns the first one whom others leave no way. Without any plans
  /// where one had better go first, if that may be.
  std::optional<std::size_t> planInTurn(const std::vector<std::size_t>& order, bool mayGoFirst) {
    plans_.assign(walkers_.size(), {});
    std::optional<std::size_t> stuck;
    for (std::size_t turn = 0; turn < order.size(); ++turn) {
      const std::size_t walker = order[turn];
      Traffic traffic = obstacles_;
      for (std::size_t other = 0; other < order.size(); ++other)
        if (other != turn) meet(order[other], other < turn, traffic);
      if (mayGoFirst && !wentFirst_[walker] && isInTheWay(walker, traffic)) {
        plans_.clear();
        return walker;
      }
      const Walker& ends = walkers_[walker];
      const PlanTask task{floor_, ends.start, ends.goal, traffic, underWay(walker), frame_};
      plans_[walker] = planWalk(prepared_, scene_, options_, task);
      const PlanStatus status = plans_[walker].report.status;
      if (!stuck && (status == PlanStatus::kNoMotion || status == PlanStatus::kBudgetSpent)) stuck = walker;
    }
    return stuck;
  }

  /// Whether others come over a walker's goal after it is likely to be there: they can go around who stands
  /// there, but it would have to wait for them. Not where one of them stays there.
  bool isInTheWay(std::size_t walker, Traffic& traffic) const {
    const Walker& ends = walkers_[walker];
    const double seconds = (ends.goal.position - ends.start.position).norm() / kLikelyMetresPerSecond;
    const auto frames = static_cast<std::uint32_t>(seconds * prepared_.library.frames.framesPerSecond);
    return !traffic.staysClearOfBodies(ends.goal.position, frames) &&
           traffic.staysClearOfBodies(ends.goal.position, Traffic::kInTheEnd);
  }

  /// Adds another walker as what moves: its walk when it is planned, else where it is at first.
  void meet(std::size_t other, bool planned, Traffic& traffic) const {
    const std::array<Vec2, 1> start = {walkers_[other].start.position};
    if (planned && hasArrived(plans_[other])) {
      traffic.addBody(placesOf(plans_[other]));
    } else if (planned) {
      traffic.addBody(start);
    } else if (const Plan* walk = underWay(other)) {
      traffic.addBody(placesOf(*walk), static_cast<std::uint32_t>(frame_) + kUnplannedFrames);
    } else {
      traffic.addBody(start, kUnplannedFrames);
    }
  }

  const Prepared& prepared_;
  const Scene& scene_;
  const FloorPlan& floor_;
  const PlanOptions& options_;
  const Plan* current_ = nullptr;
  std::size_t frame_ = 0;
  Traffic obstacles_;
  std::vector<Walker> walkers_;
  std::vector<bool> wentFirst_;  ///< Who has gone before all others once.
  std::vector<Plan> plans_;
};

}  // namespace

WalkPlanner::WalkPlanner(std::shared_ptr<const MotionLibrary> library)
    : library_(std::move(library)),
      sources_(sourceFigures(*library_)),
      tables_(*library_, sources_.limits),
      paces_(std::make_unique<PaceTables>(tables_.graph, tables_.steering, library_->frames.framesPerSecond)),
      feet_(*library_) {}

Result<Plan> WalkPlanner::plan(const Scene& scene, const PlanOptions& options) const {
  if (auto checked = checkScene(scene); !checked) return fail(std::move(checked));
  if (auto checked = checkOptions(options); !checked) return fail(std::move(checked));
  const Prepared prepared{*library_, tables_, feet_, sources_, *paces_};
  const FloorPlan floor = floorOf(scene, options);
  return Crowd(prepared, scene, floor, options).run();
}

Result<Plan> WalkPlanner::replan(const Plan& current, std::size_t frame, const Scene& scene,
                                 const PlanOptions& options) const {
  if (auto checked = checkScene(scene); !checked) return fail(std::move(checked));
  if (auto checked = checkOptions(options); !checked) return fail(std::move(checked));
  if (current.others.size() != scene.walkers.size())
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("walkers: found {}, expected {} as in the walk under way", scene.walkers.size(),
                            current.others.size()));
  const FloorPlan floor = floorOf(scene, options);
  const bool holds =
      allArrive(current) && askedAlike(current, options) && stillHolds(current, frame, scene, floor);
  if (holds && nothingFreed(current, scene)) return keptIn(scene, current);
  const Prepared prepared{*library_, tables_, feet_, sources_, *paces_};
  Plan other = Crowd(prepared, scene, floor, options).run(&current, frame);
  const bool worthTurning =
      allArrive(other) && metresLeft(other, frame) <= (1.0 - kWorthTurning) * metresLeft(current, frame);
  return holds && !worthTurning ? keptIn(scene, current) : other;
}

}  // namespace stridegraph
