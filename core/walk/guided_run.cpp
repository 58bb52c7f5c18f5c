#include "walk/guided_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stridegraph {
namespace {

constexpr std::uint64_t kExpansionsBetweenTimeChecks = 256;
constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

/// States so near in time are one where time matters.
constexpr std::uint32_t kFramesTogether = 15;

/// The weight grows for the first time after so many states, and so many more for each metre to the goal;
/// then whenever their number has grown by this factor. It costs next to nothing, since what was reached
/// stays: most walks are found before.
constexpr double kFirstRaise = 300.0;
constexpr double kRaisePerMetre = 10.0;
constexpr double kRaiseInterval = 1.4;

/// A state is given up when its cost and this share of what it is estimated to have before it come to more
/// than the walk may cost: estimates are no bounds, and up to so much too high.
constexpr double kBelievedShare = 0.9;

}  // namespace

GuidedRun::GuidedRun(GuidedTask& task, const GuidedSearchParams& params, const GuidedStage& stage,
                     const WalkEnd& end)
    : query_(task.query()),
      params_(params),
      stage_(stage),
      costToGo_(task.costToGo()),
      field_(task.field()),
      end_(end) {
  const WalkConstraints& constraints = *query_.constraints;
  const double framesPerSecond = query_.library.frames.framesPerSecond;
  if (constraints.any()) {
    wishes_.emplace(constraints, framesPerSecond);
    if (const std::optional<double>& latest = constraints.latestArrivalSeconds) {
      lastFrame_ = static_cast<std::uint32_t>(*latest * framesPerSecond);
      hurry_ = query_.paces->hurry();
    }
  }
  timed_ = lastFrame_ != kNone || task.meetsOthers();
  if (!end.facing || !query_.goal.heading) return;
  goalHeading_ = Heading::fromAngle(*query_.goal.heading);
  goalCosine_ = Heading::fromAngle(query_.goalTurn).cos;
}

void GuidedRun::begin(std::vector<StartHeading> starts, double costBound) {
  costBound_ = costBound;
  weight_ = stage_.heuristicWeight;
  metresFromStart_ = field_.metresToGoal(query_.start.position);
  nextRaise_ = kFirstRaise + kRaisePerMetre * metresFromStart_;
  if (query_.onward) {
    beginOnward(*query_.onward);
    movingBegun_ = true;
  } else {
    starts_ = std::move(starts);
    begin(starts_[begunStarts_++], true);
  }
}

bool GuidedRun::advance(std::uint64_t expansions) {
  const std::uint64_t limit = result_.expansions + std::min(expansions, kUnlimited - result_.expansions);
  for (;;) {
    if (!movingBegun_ && (open_.empty() || open_.least() >= leastMovingValue(metresFromStart_)))
      beginMoving();
    if (open_.empty()) beginTurned();
    if (open_.empty()) break;
    const std::uint32_t id = open_.pop();
    const State state = states_[id];
    if (!state.isEnd() && closed_.contains(key(state))) continue;
    if (isLeftBehind(state) || !isOpen(id)) continue;
    if (state.isEnd()) {
      if (tryEnd(id)) break;
      continue;
    }
    if (result_.expansions == limit || outOfTime(result_.expansions)) {
      open_.push(valueOf(state), id);
      if (result_.path.steps.empty()) result_.status = SearchStatus::kBudgetSpent;
      return false;
    }
    closed_.insert(key(state));
    countExpansion();
    expand(id);
  }
  if (result_.path.steps.empty()) result_.status = SearchStatus::kNoMotion;
  return true;
}

/// Grows greedier the more states are looked at.
void GuidedRun::countExpansion() {
  if (static_cast<double>(++result_.expansions) < nextRaise_) return;
  nextRaise_ *= kRaiseInterval;
  beginTurned();
  raiseWeight();
}

/// Whether a state is so far behind the front that it is passed over.
bool GuidedRun::isLeftBehind(const State& state) {
  if (!std::isfinite(stage_.windowMetres) || state.isEnd()) return false;
  const double behind = field_.metresToGoal(state.placement.translation) - trouble_.metresLeft;
  if (behind <= stage_.windowMetres) return false;
  leftBehind_ = true;
  return true;
}

/// Begins with a heading, from a stand or in motion.
void GuidedRun::begin(const StartHeading& start, bool standing) {
  const SearchGraph& graph = query_.tables.graph;
  for (const SearchStart& first : stage_.everyWay ? graph.starts() : graph.usualStarts()) {
    if (first.stands != standing) continue;
    State from;
    from.placement = {query_.start.position, start.heading};
    from.cost = start.costMetres + (standing ? 0.0 : movingStartMetres());
    reach(kNone, from, first.edge);
    startOf_.resize(states_.size(), start.heading);
  }
}

/// Begins with all other headings, which only hard starts need.
void GuidedRun::beginTurned() {
  while (begunStarts_ < starts_.size()) {
    const StartHeading& start = starts_[begunStarts_++];
    begin(start, true);
    if (movingBegun_) begin(start, false);
  }
}

/// Begins in motion, too. There are many ways to, and where a body can begin from a stand few are worth it,
/// so they wait until their turn comes.
void GuidedRun::beginMoving() {
  movingBegun_ = true;
  for (std::size_t i = 0; i < begunStarts_; ++i) begin(starts_[i], false);
}

/// What beginning in motion counts for, metres.
double GuidedRun::movingStartMetres() const {
  if (!query_.standing || !query_.tables.graph.canStartStanding()) return 0.0;
  return params_.cost.movingStart + (wishes_ ? wishes_->ofMovingStart() : 0.0);
}

/// About the least value of a state that a walk which begins in motion comes to first.
double GuidedRun::leastMovingValue(double metresToGoal) const {
  return movingStartMetres() + weight_ * (query_.tables.steering.costPerMetre() * metresToGoal);
}

void GuidedRun::beginOnward(const Onward& onward) {
  State state;
  state.placement = onward.placement;
  state.node = onward.node;
  state.frame = onward.frame;
  trouble_.begun = true;
  open(state, costToGo_.metres(onward.node, onward.placement));
}

void GuidedRun::expand(std::uint32_t id) {
  const State state = states_[id];
  const double left = field_.metresToGoal(state.placement.translation);
  if (left < trouble_.metresLeft) {
    trouble_.metresLeft = left;
    trouble_.nearest = state.placement.translation;
  }
  if (end_.standing) openArrival(id, state);
  const SearchGraph& graph = query_.tables.graph;
  for (const SearchEdge& edge :
       stage_.everyWay ? graph.edgesFrom(state.node) : graph.usualEdgesFrom(state.node))
    reach(id, state, edge);
}

/// Opens the state at the end of a way, and the walk's end on it if there is one. Whether the way is free is
/// asked only when its turn comes.
void GuidedRun::reach(std::uint32_t parent, const State& from, const SearchEdge& edge) {
  openEndOn(parent, from, edge);
  if (edge.to == kNone) return;
  State state;
  state.placement = from.placement * edge.end;
  state.node = edge.to;
  state.frame = from.frame + edge.sampleCount;
  state.via = &edge;
  state.parent = parent;
  if (closed_.contains(key(state))) return;
  state.cost = from.cost + costOf(from.placement, edge);
  const double toGo = costToGo(state);
  if (std::isfinite(toGo)) open(state, toGo);
}

/// Whether the way to a state, or an arrival, touches nothing.
bool GuidedRun::isOpen(std::uint32_t id) {
  const State& state = states_[id];
  if (state.via == nullptr) return true;
  bool free = false;
  if (state.isEnd()) {
    const Eigen::Vector2f& last = query_.tables.graph.samplesOf(*state.via)[state.goalSample];
    free = isFree(state.placement, state.frame, *state.via, state.goalSample + 1) &&
           mayStay(state.placement * Vec2(last.cast<double>()), state.frame + state.goalSample + 1);
  } else {
    const std::uint32_t samples = state.via->sampleCount;
    const FloorTransform from = state.parent == kNone ? FloorTransform{query_.start.position, startOf_[id]}
                                                      : states_[state.parent].placement;
    free = isFree(from, state.frame - samples, *state.via, samples);
  }
  trouble_.begun = trouble_.begun || free;
  return free;
}

void GuidedRun::open(State state, double toGo) {
  state.toGo = toGo;
  if (state.cost + kBelievedShare * toGo >= costBound_) return;
  open_.push(valueOf(state), static_cast<std::uint32_t>(states_.size()));
  states_.push_back(state);
}

void GuidedRun::raiseWeight() {
  if (stage_.weightGrowth == 1.0) return;
  weight_ *= stage_.weightGrowth;
  open_.revalue([this](std::uint32_t id) { return valueOf(states_[id]); });
}

/// Whether the first samples of a way touch nothing; the body is at its beginning at that frame.
bool GuidedRun::isFree(const FloorTransform& from, std::uint32_t frame, const SearchEdge& edge,
                       std::uint32_t samples) {
  const std::span<const Eigen::Vector2f> points = query_.tables.graph.samplesOf(edge).first(samples);
  for (const Eigen::Vector2f& sample : points) {
    const Vec2 point = from * Vec2(sample.cast<double>());
    if (query_.plan.isFree(point)) continue;
    trouble_.blocked = point;
    trouble_.blockedFrame = frame;
    return false;
  }
  if (query_.traffic == nullptr || query_.traffic->isFree(from, points, frame + 1)) return true;
  ++trouble_.atTraffic;
  trouble_.blocked = from.translation;
  trouble_.blockedFrame = frame;
  return false;
}

double GuidedRun::costOf(const FloorTransform& from, const SearchEdge& edge) const {
  const WalkCost& cost = params_.cost;
  const double variation = 1.0 + cost.seedVariation * seededShare(edge);
  const double metres = cost.ofGoing(edge, query_.library.frames.framesPerSecond) * variation +
                        stage_.transitionFactor * cost.ofTransitions(edge);
  if (!wishes_) return metres;
  const double places =
      wishes_->asksForPlaces() ? wishes_->ofPlaces(from, query_.tables.graph.samplesOf(edge)) : 0.0;
  return metres + places + wishes_->ofPace(edge);
}

/// 0..1, different for each edge and seed.
double GuidedRun::seededShare(const SearchEdge& edge) const {
  const std::uint64_t mixed =
      (edge.firstSample + query_.seed * 0x9e3779b97f4a7c15ULL) * 0xbf58476d1ce4e5b9ULL;
  return static_cast<double>(mixed >> 40U) * 0x1.0p-24;
}

/// Whether not even the library's fastest walk, along the disc's way, would be there in time.
bool GuidedRun::isTooLate(const State& state) {
  const Vec2& at = state.placement.translation;
  // Where areas make metres count for more, the field does not tell them.
  const double way =
      query_.constraints->areas.empty() ? field_.metresToGoal(at) : (query_.goal.position - at).norm();
  const double metres = std::max(way - end_.radiusMetres, 0.0);
  const double framesPerSecond = query_.library.frames.framesPerSecond;
  const double frame = state.frame + framesPerSecond * hurry_->secondsTo(state.node, metres, end_.standing);
  if (frame <= static_cast<double>(lastFrame_)) return false;
  ++trouble_.tooLate;
  trouble_.soonestSeconds = std::min(trouble_.soonestSeconds, frame / framesPerSecond);
  return true;
}

double GuidedRun::costToGo(const State& state) {
  const double toGo = costToGo_.metres(state.node, state.placement);
  if (lastFrame_ != kNone && isTooLate(state)) return std::numeric_limits<double>::infinity();
  return end_.standing ? std::max(toGo, query_.tables.arrivals.leastMetres(state.node)) : toGo;
}

std::uint64_t GuidedRun::key(const State& state) const {
  const Vec2& at = state.placement.translation;
  const std::uint64_t x = keyPart(at.x() / stage_.cellMetres);
  const std::uint64_t z = keyPart(at.y() / stage_.cellMetres);
  const std::uint64_t turn = keyPart(quarterTurns(state.placement.heading) * 0.25 * stage_.headingCells);
  // 20 bits for the node, 14 each for the place, 6 for the heading, and 10 for the time where that matters.
  const std::uint64_t time = timed_ ? (state.frame / kFramesTogether) % 0x400U : 0;
  return (((state.node * 0x4000ULL + x) * 0x4000ULL + z) * 0x40ULL + turn) * 0x400ULL + time;
}

bool GuidedRun::outOfTime(std::uint64_t expansions) const {
  return query_.outOfTime && expansions % kExpansionsBetweenTimeChecks == 0 && query_.outOfTime();
}

}  // namespace stridegraph
