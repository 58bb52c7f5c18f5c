#include "walk/guided_task.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "path/polyline.h"
#include "walk/constraint_cost.h"

namespace stridegraph {
namespace {

/// Who has to be faster than this on average to be there in time had better be so all the way.
constexpr double kEasyMetresPerSecond = 1.0;

/// What getting going and coming to a stand take more than going on.
constexpr double kStartAndStopSeconds = 2.0;

/// Paces that it takes to be there in time are rounded up to multiples of this, metres per second, so that
/// few differ.
constexpr double kPaceStep = 0.1;

/// What the scene asks for, with the pace that it takes to be there in time. Paths are no longer than their
/// polyline.
WalkConstraints wishesOf(const MotionQuery& query) {
  if (query.constraints == nullptr) return {};
  WalkConstraints wishes = *query.constraints;
  if (!wishes.latestArrivalSeconds || wishes.minSpeedMetresPerSecond) return wishes;
  const double begun = query.onward ? query.onward->frame / query.library.frames.framesPerSecond : 0.0;
  const double left = *wishes.latestArrivalSeconds - begun;
  const double going = std::max(left - kStartAndStopSeconds, 0.5 * left);
  const double needed =
      left > 0.0 ? std::ceil(polylineLength(query.path) / going / kPaceStep) * kPaceStep : 0.0;
  if (needed <= kEasyMetresPerSecond) return wishes;
  wishes.minSpeedMetresPerSecond = std::min(needed, wishes.maxSpeedMetresPerSecond.value_or(needed));
  return wishes;
}

/// The query with other wishes, which have to outlive it.
MotionQuery withWishes(MotionQuery query, const WalkConstraints& wishes, PaceTables& paces) {
  query.constraints = &wishes;
  if (query.paces == nullptr) query.paces = &paces;
  return query;
}

/// What walks cost who is asked for a pace, which changes it for every way.
std::shared_ptr<const PaceTable> paceUnlessUsual(const MotionQuery& query) {
  if (!query.constraints->asksForPace()) return nullptr;
  return query.paces->of(*query.constraints);
}

/// The way along a field is told in strides of this length, each of which brings the goal nearer by as much
/// as this.
constexpr double kStrideMetres = 0.2;
constexpr double kLeastStrideMetres = 0.02;

/// A field of the query's own where none is known, or where areas make some metres count for more.
std::optional<DistanceField> fieldUnlessKnown(const MotionQuery& query, const SteeringTable& steering) {
  DistanceField::Params params;
  params.openPath.assign(query.path.begin(), query.path.end());
  if (!query.constraints->areas.empty()) {
    const ConstraintCost wishes(*query.constraints, query.library.frames.framesPerSecond);
    const double perMetre = steering.costPerMetre();
    params.weight = [wishes, perMetre](const Vec2& point) {
      return 1.0 + wishes.perMetreAt(point) / perMetre;
    };
  } else if (query.field != nullptr) {
    return std::nullopt;
  }
  return DistanceField(query.plan, query.goal.position, params);
}

/// The way that a field leads, point by point; empty where it cannot be told without touching something.
std::vector<Vec2> wayAlong(const DistanceField& field, const Vec2& start, const Vec2& goal) {
  std::vector<Vec2> way = {start};
  double left = field.metresToGoal(start);
  while (left > kStrideMetres) {
    const Vec2 next = way.back() + kStrideMetres * field.at(way.back()).direction;
    const double then = field.metresToGoal(next);
    if (!(then < left - kLeastStrideMetres)) return {};
    way.push_back(next);
    left = then;
  }
  way.push_back(goal);
  return way;
}

}  // namespace

GuidedTask::GuidedTask(const MotionQuery& query)
    : wishes_(wishesOf(query)),
      ownPaces_(query.tables.graph, query.tables.steering, query.library.frames.framesPerSecond),
      query_(withWishes(query, wishes_, ownPaces_)),
      pace_(paceUnlessUsual(query_)),
      ownField_(fieldUnlessKnown(query_, pace_ ? pace_->steering : query.tables.steering)),
      costToGo_(query.tables.steering, field(), {query.plan.widthMetres(), query.plan.depthMetres()},
                pace_.get()) {}

std::vector<Vec2> GuidedTask::way() const {
  if (query_.constraints->areas.empty()) return {};
  return wayAlong(field(), query_.start.position, query_.goal.position);
}

std::string GuidedTask::explain(SearchStatus status, const SearchTrouble& trouble) const {
  if (status != SearchStatus::kBudgetSpent) {
    SearchBeginning beginning{query_.start.position};
    if (meetsOthers()) beginning.mover = query_.traffic->nearestName(trouble.blocked, trouble.blockedFrame);
    return explainNoMotion(trouble, query_.plan, beginning);
  }
  return fmt::format(
      "the search used up its budget before a walk was found; {}: try another seed, a larger "
      "budget or more clips",
      nearestReached(trouble, query_.plan));
}

}  // namespace stridegraph
