#include "walk/guided_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "walk/guided_run.h"
#include "walk/guided_task.h"
#include "walk/synthesis.h"
#include "walk/walk_measures.h"

namespace stridegraph {
namespace {

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
constexpr GuidedStage kAmongMovers = {.heuristicWeight = 1.18,
                                      .weightGrowth = 1.15,
                                      .everyWay = false,
                                      .cellMetres = 0.3,
                                      .headingCells = 16,
                                      .maxExpansions = 8'000,
                                      .expansionsPerMover = 400.0};
/// Where another walk has to be bettered: what costs so little is found soon.
constexpr std::uint64_t kBetteringExpansions = 500;
constexpr double kBetteringPerMetre = 4'000.0;
/// When a stage has run through all states.
constexpr GuidedStage kFiner = {
    .heuristicWeight = 1.2, .cellMetres = 0.1, .headingCells = 48, .maxExpansions = 150'000};
/// When the budget ran out.
constexpr GuidedStage kGreedy = {.heuristicWeight = 3.0,
                                 .weightGrowth = 1.0,
                                 .transitionFactor = 0.0,
                                 .maxExpansions = 60'000,
                                 .expansionsPerMetre = 0.0};
/// The same where others move: who has to wait needs many steps, not greed, and few directions.
constexpr GuidedStage kPatient = {.heuristicWeight = 1.15,
                                  .weightGrowth = 1.15,
                                  .transitionFactor = 0.6,
                                  .everyWay = false,
                                  .cellMetres = 0.3,
                                  .headingCells = 12,
                                  .maxExpansions = 80'000,
                                  .expansionsPerMetre = 0.0};

/// Better walks are sought without greed and in finer cells, and blends count for less.
constexpr GuidedStage kBetter = {.heuristicWeight = 1.0,
                                 .weightGrowth = 1.0,
                                 .transitionFactor = 0.5,
                                 .cellMetres = 0.1,
                                 .headingCells = 48};
/// How far behind the front the search for them looks, at first and by how much further each time,
constexpr double kFirstWindowMetres = 2.0;
constexpr double kWindowGrowth = 1.5;
/// and to what share it believes what was learned from the best walk.
constexpr double kTrust = 0.6;
/// The share to which blends of the first walk count for what a better one may cost: at half their price next
/// to none is found soon, at their whole price walks take many more blends for little.
constexpr double kBlendsOfFirst = 0.75;

/// A search that came no nearer to the goal than this, metres of way, was not kept from it by how to end
/// there.
constexpr double kNearMetres = 4.0;

/// An improvement below this is none, metres of cost.
constexpr double kWorthMetres = 0.01;

}  // namespace

class GuidedSearch::Stages {
 public:
  Stages(const MotionQuery& query, const GuidedSearchParams& params) : task_(query), params_(params) {}

  const MotionResult& best() const { return best_; }

  void findFirst() {
    for (const WalkEnd& end : ends()) {
      end_ = end;
      task_.costToGo().comeToStand(end.standing);
      best_ = seek();
      if (best_.status == SearchStatus::kArrived || task_.outOfTime()) break;
      // Who does not even come near the goal finds no other end there either, unless that took too long.
      if (trouble_.metresLeft > kNearMetres && trouble_.tooLate == 0) break;
    }
    best_.expansions = expansions_;
    best_.way = task_.way();
    if (best_.status == SearchStatus::kArrived) {
      prepareImprovement();
    } else {
      best_.explanation = task_.explain(best_.status, trouble_);
    }
  }

  bool canImprove() const { return canImprove_ && left() > 0; }

  double progress() const {
    if (!canImprove()) return 1.0;
    return static_cast<double>(improvingExpansions_) /
           static_cast<double>(task_.query().improvementExpansions);
  }

  bool improve(std::uint64_t expansions) {
    bool better = false;
    for (std::uint64_t more = std::min(expansions, left()); canImprove() && more > 0;) {
      if (task_.outOfTime()) {
        canImprove_ = false;
        break;
      }
      const std::uint64_t before = improvingExpansions_;
      better = advanceImprovement(more) || better;
      more -= std::min(more, improvingExpansions_ - before);
    }
    best_.expansions = expansions_ + improvingExpansions_;
    return better;
  }

 private:
  /// Ends of a walk in the order in which they are sought.
  std::vector<WalkEnd> ends() const {
    std::vector<WalkEnd> ends;
    const MotionQuery& query = task_.query();
    const double radius = query.goalRadiusMetres;
    const bool canStand = query.standing && query.tables.graph.canEndStanding();
    if (canStand) ends.push_back({true, true, kBendableMetres, true});
    // Another walk stands where it was asked to.
    if (hasToBetter()) return ends;
    if (canStand) ends.push_back({true, true, radius});
    ends.push_back({false, true, radius});
    if (canStand && query.goal.heading) ends.push_back({true, false, radius});
    if (query.goal.heading) ends.push_back({false, false, radius});
    return ends;
  }

  bool hasToBetter() const { return std::isfinite(task_.query().costBound); }

  MotionResult seek() {
    if (hasToBetter()) {
      GuidedStage stage = task_.meetsOthers() ? kAmongMovers : kUsual;
      stage.maxExpansions = kBetteringExpansions;
      stage.expansionsPerMetre = kBetteringPerMetre;
      return tryStage(stage);
    }
    MotionResult result = tryStage(task_.meetsOthers() ? kAmongMovers : kUsual);
    if (result.status == SearchStatus::kNoMotion) result = tryStage(kFiner);
    if (result.status == SearchStatus::kBudgetSpent && !task_.outOfTime())
      result = tryStage(task_.meetsOthers() ? kPatient : kGreedy);
    return result;
  }

  MotionResult tryStage(const GuidedStage& stage) {
    stage_ = stage;
    const Traffic* const traffic = task_.query().traffic;
    const double movers = traffic == nullptr ? 0.0 : static_cast<double>(traffic->size());
    const double more =
        stage.expansionsPerMetre * task_.metresFromStart() + stage.expansionsPerMover * movers;
    GuidedRun run(task_, params_, stage_, end_);
    run.begin(startHeadings(task_.query(), params_), task_.query().costBound);
    run.advance(stage.maxExpansions + static_cast<std::uint64_t>(more));
    expansions_ += run.result().expansions;
    trouble_.add(run.trouble());
    task_.costToGo().learn(run.marks());
    return run.result();
  }

  void prepareImprovement() {
    const double cellMetres = stage_.cellMetres;
    const std::uint32_t headingCells = stage_.headingCells;
    stage_ = kBetter;
    if (task_.meetsOthers()) {
      stage_.cellMetres = cellMetres;
      stage_.headingCells = headingCells;
    }
    stage_.windowMetres = kFirstWindowMetres;
    bound_ = best_.goingMetres() + kBlendsOfFirst * best_.blendMetres;
    task_.costToGo().trust(kTrust);
    canImprove_ = !isEnough();
  }

  std::uint64_t left() const {
    const std::uint64_t all = task_.query().improvementExpansions;
    return all - std::min(all, improvingExpansions_);
  }

  /// Goes on with the run under way, or with the next one; whether it found a better walk.
  bool advanceImprovement(std::uint64_t expansions) {
    if (!run_) {
      run_.emplace(task_, params_, stage_, end_);
      run_->begin(startHeadings(task_.query(), params_), bound_ - kWorthMetres);
    }
    const std::uint64_t before = run_->result().expansions;
    const bool over = run_->advance(expansions);
    improvingExpansions_ += run_->result().expansions - before;
    if (!over && left() > 0 && !task_.outOfTime()) return false;
    const bool better = run_->result().status == SearchStatus::kArrived;
    canImprove_ = over && (better || run_->leftBehind());
    if (better) {
      std::vector<Vec2> way = std::move(best_.way);
      best_ = run_->result();
      best_.way = std::move(way);
      bound_ = best_.costMetres;
      task_.costToGo().learn(run_->marks());
      canImprove_ = canImprove_ && !isEnough();
    }
    run_.reset();
    stage_.windowMetres *= kWindowGrowth;
    return better;
  }

  bool isEnough() const {
    const MotionQuery& query = task_.query();
    if (!query.enoughRatio) return false;
    return wayLength(placementsAlong(query.library, best_.path)) <=
           *query.enoughRatio * task_.metresFromStart();
  }

  GuidedTask task_;
  GuidedSearchParams params_;
  WalkEnd end_;        ///< Sought last.
  GuidedStage stage_;  ///< Tried last.
  MotionResult best_;
  SearchTrouble trouble_;
  std::uint64_t expansions_ = 0;           ///< Before the first walk,
  std::uint64_t improvingExpansions_ = 0;  ///< and since.
  double bound_ = 0.0;                     ///< A better walk costs less.
  std::optional<GuidedRun> run_;           ///< For a better walk, while it goes on.
  bool canImprove_ = false;
};

GuidedSearch::GuidedSearch(const MotionQuery& query, const GuidedSearchParams& params)
    : stages_(std::make_unique<Stages>(query, params)) {
  stages_->findFirst();
}

GuidedSearch::~GuidedSearch() = default;

const MotionResult& GuidedSearch::best() const {
  return stages_->best();
}

bool GuidedSearch::canImprove() const {
  return stages_->canImprove();
}

bool GuidedSearch::improve(std::uint64_t expansions) {
  return stages_->improve(expansions);
}

double GuidedSearch::progress() const {
  return stages_->progress();
}

MotionResult guidedSearch(const MotionQuery& query, const GuidedSearchParams& params) {
  GuidedSearch search(query, params);
  search.improve(query.improvementExpansions);
  return search.best();
}

}  // namespace stridegraph
