#include "walk/guided_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "walk/guided_run.h"

namespace stridegraph {
namespace {

constexpr double kNoBound = std::numeric_limits<double>::infinity();

/// A walk that ends this near the goal can be bent to end on it: 5 % of its last two metres.
constexpr double kBendableMetres = 0.1;

/// Headings tried when the scene asks for none and the one along the path leads nowhere.
constexpr int kFreeHeadings = 12;

/// The headings that a walk may begin with in a stage.
std::vector<Heading> startHeadings(const MotionQuery& query, const GuidedSearchParams& params,
                                   const GuidedStage& stage) {
  std::vector<Heading> headings;
  if (query.start.heading) {
    const Angle asked = *query.start.heading;
    headings.push_back(Heading::fromAngle(asked));
    if (stage.turnStart) {
      headings.push_back(Heading::fromAngle(asked - params.startSlack));
      headings.push_back(Heading::fromAngle(asked + params.startSlack));
    }
    return headings;
  }
  const Heading along = Heading::alongDirection(query.path[1] - query.path[0]);
  headings.push_back(along);
  for (int i = 1; stage.turnStart && i < kFreeHeadings; ++i) {
    headings.push_back(along + Heading::fromAngle(Angle::degrees(360.0 * i / kFreeHeadings)));
  }
  return headings;
}

/// Stages in the order in which they are tried while budgets run out; weight, factor on transitions, cells,
/// headings, turned start, expansions, and more for each metre.
constexpr std::array<GuidedStage, 3> kStages = {
    {{1.05, 1.0, 0.2, 24, false, 2'000, 30.0}, {1.1, 1.0, 0.2, 24, false, 5'000, 80.0}, {}}};
/// The same where others move: what they cost is not in the estimate, so little greed finds nothing soon.
constexpr std::array<GuidedStage, 3> kStagesAmongMovers = {{{1.4, 1.0, 0.2, 24, false, 4'000, 60.0},
                                                            {2.0, 1.0, 0.2, 24, false, 15'000, 200.0},
                                                            {3.0, 1.0, 0.2, 24, false, 40'000, 250.0}}};
/// What follows when a stage has run through all states: other first headings, then finer cells.
constexpr std::array<GuidedStage, 2> kAfterExhaustion = {
    {{1.2, 1.0, 0.2, 24, true, 40'000, 250.0}, {1.2, 1.0, 0.1, 48, true, 150'000, 250.0}}};
/// What follows when all budgets ran out.
constexpr std::array<GuidedStage, 2> kAfterBudget = {
    {{1.5, 1.0, 0.2, 24, true, 100'000, 500.0}, {3.0, 0.0, 0.1, 48, true, 300'000, 0.0}}};

/// By how much the weight falls from one improvement to the next, and where that ends: at half of the
/// estimate nothing more will be found in time.
constexpr double kWeightFall = 0.95;
constexpr double kLeastWeight = 0.5;

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

/// A field of the query's own where none is known, or where areas make some metres count for more.
std::optional<DistanceField> fieldUnlessKnown(const MotionQuery& query) {
  DistanceField::Params params;
  params.openPath.assign(query.path.begin(), query.path.end());
  if (query.constraints != nullptr && !query.constraints->areas.empty()) {
    const ConstraintCost wishes(*query.constraints, query.library.frames.framesPerSecond);
    const double perMetre = query.tables.steering.costPerMetre();
    params.weight = [wishes, perMetre](const Vec2& point) {
      return 1.0 + wishes.perMetreAt(point) / perMetre;
    };
  } else if (query.field != nullptr) {
    return std::nullopt;
  }
  return DistanceField(query.plan, query.goal.position, params);
}

/// All stages for one kind of end.
class Cascade {
 public:
  Cascade(const MotionQuery& query, const GuidedSearchParams& params)
      : query_(query),
        params_(params),
        ownField_(fieldUnlessKnown(query)),
        field_(ownField_ ? *ownField_ : *query.field),
        costToGo_(query.tables, field_, {query.plan.widthMetres(), query.plan.depthMetres()}) {}

  MotionResult run() {
    MotionResult result;
    for (const WalkEnd& end : ends()) {
      result = seek(end);
      if (result.status == SearchStatus::kArrived) improve(result, end);
      if (result.status == SearchStatus::kArrived || outOfTime()) break;
      // Who does not even come near the goal finds no other end there either.
      if (trouble_.metresLeft > kNearMetres) break;
    }
    result.expansions = expansions_;
    if (result.status != SearchStatus::kArrived)
      result.explanation = explain(result.status, trouble_, query_);
    return result;
  }

 private:
  /// Ends of a walk in the order in which they are sought.
  std::vector<WalkEnd> ends() const {
    std::vector<WalkEnd> ends;
    const double wide = query_.goalRadiusMetres;
    const double narrow = std::min(wide, kBendableMetres);
    const bool canStand = query_.standing && query_.tables.graph.canEndStanding();
    if (canStand) ends.push_back({true, true, narrow});
    if (canStand && wide > narrow) ends.push_back({true, true, wide});
    ends.push_back({false, true, wide});
    if (canStand && query_.goal.heading) ends.push_back({true, false, wide});
    if (query_.goal.heading) ends.push_back({false, false, wide});
    return ends;
  }

  MotionResult seek(const WalkEnd& end) {
    const bool meets = query_.traffic != nullptr && !query_.traffic->empty();
    MotionResult result = tryInTurn(meets ? kStagesAmongMovers : kStages, SearchStatus::kBudgetSpent, end);
    if (result.status == SearchStatus::kNoMotion)
      result = tryInTurn(kAfterExhaustion, SearchStatus::kNoMotion, end);
    if (result.status == SearchStatus::kBudgetSpent && !outOfTime())
      result = tryInTurn(kAfterBudget, SearchStatus::kBudgetSpent, end);
    return result;
  }

  /// Tries stages until one ends otherwise than `goOn`.
  MotionResult tryInTurn(std::span<const GuidedStage> stages, SearchStatus goOn, const WalkEnd& end) {
    MotionResult result;
    for (const GuidedStage& stage : stages) {
      const auto limit =
          stage.maxExpansions +
          static_cast<std::uint64_t>(stage.expansionsPerMetre * field_.metresToGoal(query_.start.position));
      result = tryStage(stage, end, limit, kNoBound);
      stage_ = stage;
      if (result.status != goOn || outOfTime()) break;
    }
    return result;
  }

  /// Looks for better walks than the first until the budget is spent.
  void improve(MotionResult& best, const WalkEnd& end) {
    std::uint64_t left = query_.improvementExpansions;
    GuidedStage stage = stage_;
    while (left > 0 && stage.heuristicWeight > kLeastWeight && !outOfTime()) {
      stage.heuristicWeight *= kWeightFall;
      MotionResult found = tryStage(stage, end, left, best.costMetres - kWorthMetres);
      left -= std::min(left, found.expansions);
      if (found.status == SearchStatus::kArrived) best = std::move(found);
    }
  }

  MotionResult tryStage(const GuidedStage& stage, const WalkEnd& end, std::uint64_t limit, double costBound) {
    GuidedRun run(query_, params_, stage, costToGo_, field_, end);
    MotionResult result = run.search(startHeadings(query_, params_, stage), limit, costBound);
    expansions_ += result.expansions;
    trouble_.add(run.trouble());
    return result;
  }

  bool outOfTime() const { return query_.outOfTime && query_.outOfTime(); }

  const MotionQuery& query_;
  const GuidedSearchParams& params_;
  GuidedStage stage_;  ///< Tried last.
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
