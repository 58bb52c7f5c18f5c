#include "walk/guided_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "path/polyline.h"
#include "walk/guided_run.h"
#include "walk/synthesis.h"
#include "walk/walk_measures.h"

namespace stridegraph {
namespace {

constexpr double kNoBound = std::numeric_limits<double>::infinity();

/// A walk that ends this near the goal can mostly be bent to end on it: 5 % of its last five metres.
constexpr double kBendableMetres = 0.25;

/// Headings tried when the scene asks for none, evenly around from the one along the path.
constexpr int kFreeHeadings = 6;

/// What turning the start from the heading asked for counts for: only who finds no better way does it.
constexpr double kTurnedStartMetres = 1.5;

/// The headings that a walk may begin with.
std::vector<StartHeading> startHeadings(const MotionQuery& query, const GuidedSearchParams& params) {
  std::vector<StartHeading> headings;
  if (query.start.heading) {
    const Heading asked = Heading::fromAngle(*query.start.heading);
    const Heading slack = Heading::fromAngle(params.startSlack);
    return {{asked, 0.0}, {asked - slack, kTurnedStartMetres}, {asked + slack, kTurnedStartMetres}};
  }
  const Heading along = Heading::alongDirection(query.path[1] - query.path[0]);
  for (int i = 0; i < kFreeHeadings; ++i) {
    const Heading turn = Heading::fromAngle(Angle::degrees(360.0 * i / kFreeHeadings));
    headings.push_back({along + turn, i == 0 ? 0.0 : kTurnedStartMetres});
  }
  return headings;
}

/// The first attempt. With half the ways it is twice as fast, and what it finds is hardly longer.
constexpr GuidedStage kUsual = {.heuristicWeight = 1.1, .everyWay = false};
/// Where others move: what they cost is not in the estimate, so little greed finds nothing soon, and places
/// are there at many times, so there have to be fewer of them.
constexpr GuidedStage kAmongMovers = {.heuristicWeight = 1.15,
                                      .weightGrowth = 1.15,
                                      .everyWay = false,
                                      .cellMetres = 0.3,
                                      .headingCells = 16,
                                      .maxExpansions = 8'000,
                                      .expansionsPerMover = 400.0};
/// When a stage has run through all states.
constexpr GuidedStage kFiner = {
    .heuristicWeight = 1.2, .cellMetres = 0.1, .headingCells = 48, .maxExpansions = 150'000};
/// When the budget ran out.
constexpr GuidedStage kGreedy = {.heuristicWeight = 3.0,
                                 .weightGrowth = 1.0,
                                 .transitionFactor = 0.0,
                                 .maxExpansions = 60'000,
                                 .expansionsPerMetre = 0.0};
/// The same where others move: who has to wait needs many steps, not greed.
constexpr GuidedStage kPatient = {.heuristicWeight = 1.15,
                                  .weightGrowth = 1.15,
                                  .transitionFactor = 0.6,
                                  .everyWay = false,
                                  .cellMetres = 0.3,
                                  .headingCells = 16,
                                  .maxExpansions = 80'000,
                                  .expansionsPerMetre = 0.0};

/// Better walks are sought without greed and in finer cells, and blends count for less.
constexpr GuidedStage kBetter = {.heuristicWeight = 1.0,
                                 .weightGrowth = 1.0,
                                 .transitionFactor = 0.5,
                                 .cellMetres = 0.1,
                                 .headingCells = 48};
/// How far behind the front the search for them looks, at first and by how much further each time,
constexpr double kFirstWindowMetres = 3.0;
constexpr double kWindowGrowth = 1.5;
/// and to what share it believes what was learned from the best walk.
constexpr double kTrust = 0.5;
/// The share to which blends of the first walk count for what a better one may cost: at half their price next
/// to none is found soon, at their whole price walks take many more blends for little.
constexpr double kBlendsOfFirst = 0.75;

/// A search that came no nearer to the goal than this, metres of way, was not kept from it by how to end
/// there.
constexpr double kNearMetres = 4.0;

/// An improvement below this is none, metres of cost.
constexpr double kWorthMetres = 0.01;

std::string explain(SearchStatus status, const SearchTrouble& trouble, const MotionQuery& query) {
  if (status != SearchStatus::kBudgetSpent) return explainNoMotion(trouble, query.plan, query.start.position);
  return fmt::format(
      "the search used up its budget before a walk was found; {}: try another seed, a larger "
      "budget or more clips",
      nearestReached(trouble, query.plan));
}

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

/// All stages for one kind of end.
class Cascade {
 public:
  Cascade(const MotionQuery& query, const GuidedSearchParams& params)
      : wishes_(wishesOf(query)),
        ownPaces_(query.tables.graph, query.tables.steering, query.library.frames.framesPerSecond),
        query_(withWishes(query, wishes_, ownPaces_)),
        params_(params),
        pace_(paceUnlessUsual(query_)),
        ownField_(fieldUnlessKnown(query_, pace_ ? pace_->steering : query.tables.steering)),
        field_(ownField_ ? *ownField_ : *query.field),
        costToGo_(query.tables.steering, field_, {query.plan.widthMetres(), query.plan.depthMetres()},
                  pace_.get()) {}

  MotionResult run() {
    MotionResult result;
    for (const WalkEnd& end : ends()) {
      costToGo_.comeToStand(end.standing);
      result = seek(end);
      if (result.status == SearchStatus::kArrived) improve(result, end);
      if (result.status == SearchStatus::kArrived || outOfTime()) break;
      // Who does not even come near the goal finds no other end there either, unless that took too long.
      if (trouble_.metresLeft > kNearMetres && trouble_.tooLate == 0) break;
    }
    result.expansions = expansions_;
    if (!query_.constraints->areas.empty())
      result.way = wayAlong(field_, query_.start.position, query_.goal.position);
    if (result.status != SearchStatus::kArrived)
      result.explanation = explain(result.status, trouble_, query_);
    return result;
  }

 private:
  /// Ends of a walk in the order in which they are sought.
  std::vector<WalkEnd> ends() const {
    std::vector<WalkEnd> ends;
    const double radius = query_.goalRadiusMetres;
    const bool canStand = query_.standing && query_.tables.graph.canEndStanding();
    if (canStand) ends.push_back({true, true, kBendableMetres, true});
    if (canStand) ends.push_back({true, true, radius});
    ends.push_back({false, true, radius});
    if (canStand && query_.goal.heading) ends.push_back({true, false, radius});
    if (query_.goal.heading) ends.push_back({false, false, radius});
    return ends;
  }

  MotionResult seek(const WalkEnd& end) {
    MotionResult result = tryStage(meetsOthers() ? kAmongMovers : kUsual, end);
    if (result.status == SearchStatus::kNoMotion) result = tryStage(kFiner, end);
    if (result.status == SearchStatus::kBudgetSpent && !outOfTime())
      result = tryStage(meetsOthers() ? kPatient : kGreedy, end);
    return result;
  }

  MotionResult tryStage(const GuidedStage& stage, const WalkEnd& end) {
    stage_ = stage;
    const double metres = field_.metresToGoal(query_.start.position);
    const double movers = query_.traffic == nullptr ? 0.0 : static_cast<double>(query_.traffic->size());
    const double more = stage.expansionsPerMetre * metres + stage.expansionsPerMover * movers;
    GuidedRun run(query_, params_, stage, costToGo_, field_, end);
    return runOnce(run, stage.maxExpansions + static_cast<std::uint64_t>(more), kNoBound);
  }

  /// Looks for better walks than the first until the budget is spent, or nothing is left to look at.
  void improve(MotionResult& best, const WalkEnd& end) {
    GuidedStage stage = kBetter;
    if (meetsOthers()) {
      stage.cellMetres = stage_.cellMetres;
      stage.headingCells = stage_.headingCells;
    }
    costToGo_.trust(kTrust);
    std::uint64_t left = query_.improvementExpansions;
    double bound = best.goingMetres() + kBlendsOfFirst * best.blendMetres;
    bool more = true;
    for (stage.windowMetres = kFirstWindowMetres; more && left > 0 && !outOfTime() && !isEnough(best);
         stage.windowMetres *= kWindowGrowth) {
      GuidedRun run(query_, params_, stage, costToGo_, field_, end);
      MotionResult found = runOnce(run, left, bound - kWorthMetres);
      left -= std::min(left, found.expansions);
      more = found.status == SearchStatus::kArrived || run.leftBehind();
      if (found.status != SearchStatus::kArrived) continue;
      bound = found.costMetres;
      best = std::move(found);
    }
  }

  bool isEnough(const MotionResult& walk) const {
    if (!query_.enoughRatio) return false;
    return wayLength(placementsAlong(query_.library, walk.path)) <=
           *query_.enoughRatio * field_.metresToGoal(query_.start.position);
  }

  MotionResult runOnce(GuidedRun& run, std::uint64_t limit, double costBound) {
    MotionResult result = run.search(startHeadings(query_, params_), limit, costBound);
    expansions_ += result.expansions;
    trouble_.add(run.trouble());
    if (result.status == SearchStatus::kArrived) costToGo_.learn(run.marks());
    return result;
  }

  bool meetsOthers() const { return query_.traffic != nullptr && !query_.traffic->empty(); }
  bool outOfTime() const { return query_.outOfTime && query_.outOfTime(); }

  WalkConstraints wishes_;
  PaceTables ownPaces_;
  MotionQuery query_;
  const GuidedSearchParams& params_;
  GuidedStage stage_;  ///< Tried last.
  std::shared_ptr<const PaceTable> pace_;
  std::optional<DistanceField> ownField_;
  const DistanceField& field_;
  CostToGo costToGo_;
  std::uint64_t expansions_ = 0;
  SearchTrouble trouble_;
};

}  // namespace

MotionResult guidedSearch(const MotionQuery& query, const GuidedSearchParams& params) {
  return Cascade(query, params).run();
}

}  // namespace stridegraph
