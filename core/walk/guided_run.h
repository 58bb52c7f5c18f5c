#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "path/distance_field.h"
#include "walk/constraint_cost.h"
#include "walk/cost_to_go.h"
#include "walk/guided_search.h"
#include "walk/guided_task.h"
#include "walk/search_heap.h"
#include "walk/search_trouble.h"
#include "walk/state_set.h"

namespace stridegraph {

/// What a walk must be like at its end.
struct WalkEnd {
  bool standing = true;       ///< The body has come to a stand.
  bool facing = true;         ///< It faces as the goal asks, if it asks.
  double radiusMetres = 0.1;  ///< Its root is this near the goal.
  bool bent = false;          ///< Only if the query accepts it, which it does if it can be bent to the goal.
};

/// A heading that a walk may begin with, and what that counts for.
struct StartHeading {
  Heading heading;
  double costMetres = 0.0;
};

/// One run of weighted A* with the settings of a stage; it can be interrupted. Used once. The estimates of
/// the task must not change while it goes on.
class GuidedRun {
 public:
  GuidedRun(GuidedTask& task, const GuidedSearchParams& params, const GuidedStage& stage, const WalkEnd& end);

  /// Begins to look for a walk that costs less than `costBound`, metres.
  void begin(std::vector<StartHeading> starts, double costBound);
  /// Goes on until so many more states have been looked at, time is up, or it is over; whether it is over.
  bool advance(std::uint64_t expansions);
  /// What has been found so far: kBudgetSpent while a walk may still be found.
  const MotionResult& result() const { return result_; }

  /// What stood in the way, as far as was seen.
  const SearchTrouble& trouble() const { return trouble_; }

  /// Whether states were passed over because they were too far behind the front.
  bool leftBehind() const { return leftBehind_; }

  /// Where the estimate of the walk found was wrong; empty before one is found.
  const std::vector<CostToGo::Mark>& marks() const { return marks_; }

 private:
  static constexpr std::uint32_t kNone = SearchEdge::kNone;

  /// A state reached: a decision node, or an end of the walk.
  struct State {
    FloorTransform placement;  ///< At the node; of an end, where its last way or its arrival begins.
    double cost = 0.0;
    double toGo = 0.0;                 ///< As estimated when it was opened.
    std::uint32_t node = kNone;        ///< Decision node here; kNone of an end.
    std::uint32_t frame = 0;           ///< Of the walk, when the body is there.
    const SearchEdge* via = nullptr;   ///< The way that leads here; none where an arrival does.
    std::uint32_t parent = kNone;      ///< kNone for the first way of a walk.
    std::uint32_t goalSample = kNone;  ///< Sample of `via` at which the walk ends; kNone when it goes on.
    std::uint32_t arrival = kNone;     ///< The walk ends along this one; kNone when it does not.
    bool isEnd() const { return goalSample != kNone || arrival != kNone; }
    /// How much of `via` the walk goes.
    double shareOfVia() const {
      if (goalSample == kNone) return 1.0;
      return static_cast<double>(goalSample + 1) / static_cast<double>(via->sampleCount);
    }
  };

  void begin(const StartHeading& start, bool standing);
  void beginTurned();
  void beginMoving();
  double movingStartMetres() const;
  double leastMovingValue(double metresToGoal) const;
  void beginOnward(const Onward& onward);
  bool tryEnd(std::uint32_t id);
  void countExpansion();
  void expand(std::uint32_t id);
  void reach(std::uint32_t parent, const State& from, const SearchEdge& edge);
  void openEndOn(std::uint32_t parent, const State& from, const SearchEdge& edge);
  void openArrival(std::uint32_t parent, const State& state);
  void open(State state, double toGo);
  double valueOf(const State& state) const { return state.cost + weight_ * state.toGo; }
  void raiseWeight();

  bool isLeftBehind(const State& state);
  bool isOpen(std::uint32_t id);
  bool isFree(const FloorTransform& from, std::uint32_t frame, const SearchEdge& edge, std::uint32_t samples);
  bool isFree(FloorTransform from, std::uint32_t frame, std::uint32_t arrival);
  bool mayStay(const Vec2& place, std::uint32_t frame);
  bool facesGoal(const Heading& heading) const;
  double costOf(const FloorTransform& from, const SearchEdge& edge) const;
  double seededShare(const SearchEdge& edge) const;
  double costToGo(const State& state);
  bool isTooLate(const State& state);
  std::uint64_t key(const State& state) const;
  bool outOfTime(std::uint64_t expansions) const;
  MotionPath pathTo(std::uint32_t id, std::uint32_t from) const;
  bool isAccepted(std::uint32_t id) const;
  double blendMetres(std::uint32_t id) const;
  void take(std::uint32_t id);

  const MotionQuery& query_;
  const GuidedSearchParams& params_;
  const GuidedStage& stage_;
  CostToGo& costToGo_;
  const DistanceField& field_;
  WalkEnd end_;
  std::optional<ConstraintCost> wishes_;
  Heading goalHeading_;
  double goalCosine_ = -1.0;  ///< Of the largest turn from the goal's heading.
  std::vector<State> states_;
  std::vector<Heading> startOf_;  ///< Of states without a parent, the heading that each begins with.
  SearchHeap open_;
  StateSet closed_;
  std::vector<StartHeading> starts_;
  std::size_t begunStarts_ = 0;  ///< Headings that walks begin with so far,
  bool movingBegun_ = false;     ///< from a stand only or also in motion.
  double weight_ = 1.0;
  double costBound_ = 0.0;
  double metresFromStart_ = 0.0;  ///< To the goal.
  double nextRaise_ = 0.0;        ///< Of the weight, after so many states.
  std::size_t endsTried_ = 0;     ///< Ends that were not accepted.
  MotionResult result_;
  std::uint32_t lastFrame_ = kNone;     ///< The walk has to be over by then.
  std::shared_ptr<const Hurry> hurry_;  ///< Where there is a last frame.
  bool leftBehind_ = false;
  bool timed_ = false;  ///< States at different times differ.
  SearchTrouble trouble_;
  std::vector<CostToGo::Mark> marks_;
};

}  // namespace stridegraph
