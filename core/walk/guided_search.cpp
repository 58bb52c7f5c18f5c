#include "walk/guided_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "base/hash.h"
#include "path/distance_field.h"
#include "walk/search_heap.h"
#include "walk/state_set.h"

namespace stridegraph {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint64_t kExpansionsBetweenTimeChecks = 256;

/// Headings tried when the scene asks for none and the one along the path leads nowhere.
constexpr int kFreeHeadings = 12;

/// A state reached: a decision node, or a place inside an edge where the walk may end.
struct State {
  FloorTransform placement;
  double cost = 0.0;
  const SearchEdge* via = nullptr;
  std::uint32_t parent = kNone;      ///< kNone for the first way of a walk.
  std::uint32_t goalSample = kNone;  ///< Sample of `via` at which the goal is reached; kNone when it is not.
};

/// Rises from 0 to 4 with the heading, without trigonometry.
double pseudoAngle(const Heading& heading) {
  const double p = heading.sin / (std::abs(heading.sin) + std::abs(heading.cos));
  if (heading.cos < 0.0) return 2.0 - p;
  return p < 0.0 ? 4.0 + p : p;
}

/// One run of weighted A* with the settings of a stage.
class Run {
 public:
  Run(const MotionQuery& query, const GuidedSearchParams& params, const GuidedStage& stage,
      const DistanceField& field)
      : query_(query), params_(params), stage_(stage), field_(field) {}

  MotionResult search(std::span<const Heading> startHeadings) {
    MotionResult result;
    for (const Heading& heading : startHeadings) begin({query_.start.position, heading});
    const std::uint64_t limit =
        stage_.maxExpansions +
        static_cast<std::uint64_t>(stage_.expansionsPerMetre * field_.metresToGoal(query_.start.position));
    while (!open_.empty()) {
      const std::uint32_t id = open_.pop();
      if (states_[id].goalSample != kNone) {
        result.status = SearchStatus::kArrived;
        result.path = pathTo(id);
        break;
      }
      if (!closed_.insert(key(states_[id]))) continue;
      if (result.expansions == limit || outOfTime(result.expansions)) {
        result.status = SearchStatus::kBudgetSpent;
        break;
      }
      ++result.expansions;
      const State state = states_[id];
      for (const SearchEdge& edge : query_.graph.edgesFrom(state.via->to)) {
        reach(id, state.placement, state.cost, edge);
      }
    }
    return result;
  }

  /// Whether any way to begin could be walked to its end.
  bool begun() const { return begun_; }

 private:
  void begin(const FloorTransform& start) {
    for (const SearchEdge& edge : query_.graph.starts()) {
      const std::size_t before = states_.size();
      reach(kNone, start, 0.0, edge);
      for (std::size_t s = before; s < states_.size(); ++s) startOf_.push_back(start.heading);
      begun_ = begun_ || states_.size() > before;
    }
  }

  /// Walks an edge from a placement, frame by frame; opens the state at its end unless something is in the
  /// way, and the place on it that is nearest the goal if that is near enough.
  void reach(std::uint32_t parent, const FloorTransform& from, double cost, const SearchEdge& edge) {
    const std::span<const Eigen::Vector2f> samples = query_.graph.samplesOf(edge);
    double nearest = query_.goalRadiusMetres;
    std::uint32_t goalSample = kNone;
    for (std::uint32_t s = 0; s < samples.size(); ++s) {
      const Vec2 point = from * Vec2(samples[s].cast<double>());
      if (!query_.plan.isFree(point)) {
        openGoal(parent, from, cost, edge, goalSample);
        return;
      }
      const double toGoal = (point - query_.goal).norm();
      if (toGoal < nearest) {
        nearest = toGoal;
        goalSample = s;
      }
    }
    openGoal(parent, from, cost, edge, goalSample);
    State state{from * edge.end, cost + costOf(edge), &edge, parent, kNone};
    if (closed_.contains(key(state))) return;
    const double toGo = field_.metresToGoal(state.placement.translation);
    if (!std::isfinite(toGo)) return;
    open(std::move(state), toGo);
  }

  void openGoal(std::uint32_t parent, const FloorTransform& from, double cost, const SearchEdge& edge,
                std::uint32_t goalSample) {
    if (goalSample == kNone) return;
    const double share = static_cast<double>(goalSample + 1) / static_cast<double>(edge.sampleCount);
    open({from, cost + share * costOf(edge), &edge, parent, goalSample}, 0.0);
  }

  void open(State state, double toGo) {
    open_.push(state.cost + stage_.heuristicWeight * toGo, static_cast<std::uint32_t>(states_.size()));
    states_.push_back(std::move(state));
  }

  double costOf(const SearchEdge& edge) const {
    const WalkCost& cost = params_.cost;
    const double seconds = static_cast<double>(edge.sampleCount) / query_.library.frames.framesPerSecond;
    const double transitions =
        cost.perTransition * edge.transitions + cost.perTransitionMetre * edge.transitionDistanceMetres;
    const double variation = 1.0 + cost.seedVariation * seededShare(edge);
    return (edge.lengthMetres + cost.perSecond * seconds) * variation + stage_.transitionFactor * transitions;
  }

  /// 0..1, different for each edge and seed.
  double seededShare(const SearchEdge& edge) const {
    const std::uint64_t mixed =
        (edge.firstSample + query_.seed * 0x9e3779b97f4a7c15ULL) * 0xbf58476d1ce4e5b9ULL;
    return static_cast<double>(mixed >> 40U) * 0x1.0p-24;
  }

  std::uint64_t key(const State& state) const {
    const Vec2& at = state.placement.translation;
    const auto x = static_cast<std::uint64_t>(at.x() / stage_.cellMetres);
    const auto z = static_cast<std::uint64_t>(at.y() / stage_.cellMetres);
    const auto turn =
        static_cast<std::uint64_t>(pseudoAngle(state.placement.heading) * 0.25 * stage_.headingCells);
    return ((state.via->to * 0x4000ULL + x) * 0x4000ULL + z) * 0x100ULL + turn;
  }

  bool outOfTime(std::uint64_t expansions) const {
    return query_.outOfTime && expansions % kExpansionsBetweenTimeChecks == 0 && query_.outOfTime();
  }

  MotionPath pathTo(std::uint32_t id) const {
    std::vector<std::uint32_t> chain;
    for (std::uint32_t at = id; at != kNone; at = states_[at].parent) chain.push_back(at);
    MotionPath path;
    path.start = {query_.start.position, startHeading(chain.back())};
    for (auto it = chain.rbegin(); it != chain.rend(); ++it) {
      const State& state = states_[*it];
      std::uint32_t left = state.goalSample == kNone ? kNone : state.goalSample + 1;
      for (WalkStep step : query_.graph.stepsOf(*state.via)) {
        step.end = step.begin + std::min(step.end - step.begin, left);
        if (left != kNone) left -= step.end - step.begin;
        if (step.end > step.begin) path.steps.push_back(step);
      }
    }
    return path;
  }

  /// First states are the first in the list, each with the heading that its walk begins with.
  Heading startHeading(std::uint32_t first) const { return startOf_[first]; }

  const MotionQuery& query_;
  const GuidedSearchParams& params_;
  const GuidedStage& stage_;
  const DistanceField& field_;
  std::vector<State> states_;
  std::vector<Heading> startOf_;
  SearchHeap open_;
  StateSet closed_;
  bool begun_ = false;
};

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

}  // namespace

MotionResult guidedSearch(const MotionQuery& query, const GuidedSearchParams& params) {
  const DistanceField field(query.plan, query.goal, {.openPath = {query.path.begin(), query.path.end()}});
  MotionResult result;
  std::uint64_t expansions = 0;
  bool begun = false;
  const auto tryStage = [&](const GuidedStage& stage) {
    Run run(query, params, stage, field);
    result = run.search(startHeadings(query, params, stage));
    expansions += result.expansions;
    begun = begun || run.begun();
    return result.status;
  };
  for (const GuidedStage& stage : kAfterExhaustion) {
    if (tryStage(stage) != SearchStatus::kNoMotion) break;
  }
  for (const GuidedStage& stage : kAfterBudget) {
    if (result.status != SearchStatus::kBudgetSpent || (query.outOfTime && query.outOfTime())) break;
    tryStage(stage);
  }
  result.expansions = expansions;
  if (result.status != SearchStatus::kArrived) result.explanation = explain(result.status, begun);
  return result;
}

}  // namespace stridegraph
