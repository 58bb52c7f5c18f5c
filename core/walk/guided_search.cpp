#include "walk/guided_search.h"

#include <algorithm>
#include <array>
#include <vector>

#include "walk/guided_run.h"

namespace stridegraph {
namespace {

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

/// Stages in the order in which they are tried: those after the first answer an open list that ran empty,
/// those of the second row a budget that ran out.
constexpr std::array<GuidedStage, 3> kAfterExhaustion = {
    {{}, {1.3, 1.0, 0.2, 24, true, 40'000, 250.0}, {1.3, 1.0, 0.1, 48, true, 400'000, 250.0}}};
constexpr std::array<GuidedStage, 2> kAfterBudget = {
    {{1.5, 1.0, 0.2, 24, true, 100'000, 500.0}, {3.0, 0.0, 0.1, 48, true, 1'000'000, 0.0}}};

std::string explain(SearchStatus status, bool begun) {
  if (status == SearchStatus::kBudgetSpent) {
    return "the search used up its budget before a walk was found: try another seed, a larger budget or more "
           "clips";
  }
  if (!begun)
    return "every first step from the start touches something: the start is too near a wall or faces it";
  return "no walk that these clips can make leads through: every way on ends at a wall; more clips, tighter "
         "turns or a mirrored library would help";
}

/// All stages for one kind of end.
class Cascade {
 public:
  Cascade(const MotionQuery& query, const GuidedSearchParams& params)
      : query_(query),
        params_(params),
        field_(query.plan, query.goal.position, {.openPath = {query.path.begin(), query.path.end()}}) {}

  MotionResult run() {
    MotionResult result;
    for (const WalkEnd& end : ends()) {
      result = seek(end);
      if (result.status == SearchStatus::kArrived || outOfTime()) break;
    }
    result.expansions = expansions_;
    if (result.status != SearchStatus::kArrived) result.explanation = explain(result.status, begun_);
    return result;
  }

 private:
  /// Ends of a walk in the order in which they are sought.
  std::vector<WalkEnd> ends() const {
    std::vector<WalkEnd> ends;
    const double wide = query_.goalRadiusMetres;
    const double narrow = std::min(wide, kBendableMetres);
    const bool canStand = query_.standing && query_.graph.canEndStanding();
    if (canStand) ends.push_back({true, true, narrow});
    if (canStand && wide > narrow) ends.push_back({true, true, wide});
    ends.push_back({false, true, wide});
    if (canStand && query_.goal.heading) ends.push_back({true, false, wide});
    if (query_.goal.heading) ends.push_back({false, false, wide});
    return ends;
  }

  MotionResult seek(const WalkEnd& end) {
    MotionResult result;
    for (const GuidedStage& stage : kAfterExhaustion) {
      result = tryStage(stage, end);
      if (result.status != SearchStatus::kNoMotion) break;
    }
    for (const GuidedStage& stage : kAfterBudget) {
      if (result.status != SearchStatus::kBudgetSpent || outOfTime()) break;
      result = tryStage(stage, end);
    }
    return result;
  }

  MotionResult tryStage(const GuidedStage& stage, const WalkEnd& end) {
    GuidedRun run(query_, params_, stage, field_, end);
    MotionResult result = run.search(startHeadings(query_, params_, stage));
    expansions_ += result.expansions;
    begun_ = begun_ || run.begun();
    return result;
  }

  bool outOfTime() const { return query_.outOfTime && query_.outOfTime(); }

  const MotionQuery& query_;
  const GuidedSearchParams& params_;
  DistanceField field_;
  std::uint64_t expansions_ = 0;
  bool begun_ = false;
};

}  // namespace

MotionResult guidedSearch(const MotionQuery& query, const GuidedSearchParams& params) {
  return Cascade(query, params).run();
}

}  // namespace stridegraph
