#include "walk/guided_run.h"

#include <algorithm>
#include <cmath>

namespace stridegraph {
namespace {

constexpr std::uint64_t kExpansionsBetweenTimeChecks = 256;

/// Arrivals looked at for one state: the cheapest that end at the goal.
constexpr std::size_t kArrivalsTried = 6;
constexpr std::size_t kArrivalsOpened = 2;

/// Ends looked at before the first is taken though it is not accepted.
constexpr std::size_t kEndsTried = 80;

/// Appends a way, cut off behind one of its samples.
void appendWay(const SearchGraph& graph, const SearchEdge& way, std::uint32_t lastSample,
               std::vector<WalkStep>& steps) {
  std::uint32_t left = lastSample == SearchEdge::kNone ? way.sampleCount : lastSample + 1;
  for (WalkStep step : graph.stepsOf(way)) {
    step.end = step.begin + std::min(step.end - step.begin, left);
    left -= step.end - step.begin;
    if (step.end > step.begin) steps.push_back(step);
  }
}

}  // namespace

GuidedRun::GuidedRun(const MotionQuery& query, const GuidedSearchParams& params, const GuidedStage& stage,
                     CostToGo& costToGo, const DistanceField& field, const WalkEnd& end)
    : query_(query), params_(params), stage_(stage), costToGo_(costToGo), field_(field), end_(end) {
  if (!end.facing || !query.goal.heading) return;
  goalHeading_ = Heading::fromAngle(*query.goal.heading);
  goalCosine_ = Heading::fromAngle(query.goalTurn).cos;
}

MotionResult GuidedRun::search(std::span<const Heading> startHeadings, std::uint64_t limit,
                               double costBound) {
  costBound_ = costBound;
  MotionResult result;
  std::size_t ends = 0;
  for (const Heading& heading : startHeadings) begin({query_.start.position, heading});
  while (!open_.empty()) {
    const std::uint32_t id = open_.pop();
    const State state = states_[id];
    if (!state.isEnd() && closed_.contains(key(state))) continue;
    if (!isOpen(id)) continue;
    if (state.isEnd()) {
      MotionPath path = pathTo(id);
      const bool accepted = !query_.accepts || query_.accepts(path);
      if (accepted || result.path.steps.empty()) {
        result.path = std::move(path);
        result.costMetres = state.cost;
      }
      result.status = SearchStatus::kArrived;
      if (accepted || ++ends == kEndsTried) break;
      continue;
    }
    if (result.expansions == limit || outOfTime(result.expansions)) {
      if (ends == 0) result.status = SearchStatus::kBudgetSpent;
      break;
    }
    closed_.insert(key(state));
    ++result.expansions;
    expand(id);
  }
  return result;
}

void GuidedRun::begin(const FloorTransform& start) {
  for (const SearchStart& first : query_.tables.graph.starts()) {
    const bool charged = query_.standing && query_.tables.graph.canStartStanding() && !first.stands;
    reach(kNone, start, charged ? params_.cost.movingStart : 0.0, first.edge);
    startOf_.resize(states_.size(), start.heading);
  }
}

void GuidedRun::expand(std::uint32_t id) {
  const State state = states_[id];
  if (end_.standing) openArrival(id, state);
  for (const SearchEdge& edge : query_.tables.graph.edgesFrom(state.via->to)) {
    reach(id, state.placement, state.cost, edge);
  }
}

/// Opens the state at the end of a way, and the walk's end on it if there is one. Whether the way is free is
/// asked only when its turn comes.
void GuidedRun::reach(std::uint32_t parent, const FloorTransform& from, double cost, const SearchEdge& edge) {
  openEndOn(parent, from, cost, edge);
  if (edge.to == kNone) return;
  const State state{from * edge.end, cost + costOf(edge), &edge, parent, kNone, kNone};
  if (closed_.contains(key(state))) return;
  const double toGo = costToGo(state);
  if (std::isfinite(toGo)) open(state, toGo);
}

void GuidedRun::openEndOn(std::uint32_t parent, const FloorTransform& from, double cost,
                          const SearchEdge& edge) {
  const double reach = edge.lengthMetres + end_.radiusMetres;
  if ((from.translation - query_.goal.position).squaredNorm() > reach * reach) return;
  if (end_.standing && edge.settledSample == kNone) return;
  const std::span<const Eigen::Vector2f> samples = query_.tables.graph.samplesOf(edge);
  const std::span<const Eigen::Vector2f> headings = query_.tables.graph.headingsOf(edge);
  double nearest = end_.radiusMetres;
  std::uint32_t goalSample = kNone;
  const std::uint32_t first = end_.standing ? edge.settledSample : 0;
  const std::uint32_t last = end_.standing ? first : edge.sampleCount - 1;
  for (std::uint32_t s = first; s <= last; ++s) {
    const Vec2 point = from * Vec2(samples[s].cast<double>());
    const double toGoal = (point - query_.goal.position).norm();
    if (toGoal >= nearest) continue;
    if (!facesGoal(from.heading + Heading{double{headings[s].x()}, double{headings[s].y()}})) continue;
    nearest = toGoal;
    goalSample = s;
  }
  openEnd(parent, from, cost, edge, goalSample);
}

/// Whether the way to a state, or an arrival, touches nothing.
bool GuidedRun::isOpen(std::uint32_t id) {
  const State& state = states_[id];
  if (state.via == nullptr) return true;
  const FloorTransform from =
      state.isEnd() ? state.placement
                    : (state.parent == kNone ? FloorTransform{query_.start.position, startOf_[id]}
                                             : states_[state.parent].placement);
  const bool free = isFree(from, *state.via, state.isEnd() ? state.goalSample + 1 : state.via->sampleCount);
  begun_ = begun_ || free;
  return free;
}

void GuidedRun::openEnd(std::uint32_t parent, const FloorTransform& from, double cost, const SearchEdge& edge,
                        std::uint32_t sample) {
  if (sample == kNone) return;
  const double share = static_cast<double>(sample + 1) / static_cast<double>(edge.sampleCount);
  open({from, cost + share * costOf(edge), &edge, parent, sample, kNone}, 0.0);
}

/// Opens the cheapest ways from a state to a stand at the goal that are known and free.
void GuidedRun::openArrival(std::uint32_t parent, const State& state) {
  if (field_.metresToGoal(state.placement.translation) > query_.tables.arrivals.reachMetres()) return;
  const FloorTransform nodeFromRoom = state.placement.inverse();
  std::size_t tried = 0;
  std::size_t opened = 0;
  for (const std::uint32_t id :
       query_.tables.arrivals.near(state.via->to, nodeFromRoom * query_.goal.position, end_.radiusMetres)) {
    const Arrival& arrival = query_.tables.arrivals[id];
    if (!facesGoal(state.placement.heading + arrival.end.heading)) continue;
    if (isFree(state.placement, id)) {
      open({state.placement, state.cost + arrival.costMetres, nullptr, parent, kNone, id}, 0.0);
      if (++opened == kArrivalsOpened) return;
    }
    if (++tried == kArrivalsTried) return;
  }
}

void GuidedRun::open(const State& state, double toGo) {
  const double value = state.cost + stage_.heuristicWeight * toGo;
  if (value >= costBound_) return;
  open_.push(value, static_cast<std::uint32_t>(states_.size()));
  states_.push_back(state);
}

bool GuidedRun::isFree(const FloorTransform& from, const SearchEdge& edge, std::uint32_t samples) const {
  const std::span<const Eigen::Vector2f> points = query_.tables.graph.samplesOf(edge).first(samples);
  return std::all_of(points.begin(), points.end(), [&](const Eigen::Vector2f& point) {
    return query_.plan.isFree(from * Vec2(point.cast<double>()));
  });
}

bool GuidedRun::isFree(FloorTransform from, std::uint32_t arrival) const {
  for (; arrival != kNone; arrival = query_.tables.arrivals[arrival].next) {
    const Arrival& at = query_.tables.arrivals[arrival];
    const SearchEdge& edge = query_.tables.graph.edges()[at.edge];
    if (!isFree(from, edge, at.next == kNone ? edge.settledSample + 1 : edge.sampleCount)) return false;
    from = from * edge.end;
  }
  return true;
}

bool GuidedRun::facesGoal(const Heading& heading) const {
  return goalCosine_ <= -1.0 || (heading - goalHeading_).cos >= goalCosine_;
}

double GuidedRun::costOf(const SearchEdge& edge) const {
  const WalkCost& cost = params_.cost;
  const double variation = 1.0 + cost.seedVariation * seededShare(edge);
  return cost.ofGoing(edge, query_.library.frames.framesPerSecond) * variation +
         stage_.transitionFactor * cost.ofTransitions(edge);
}

/// 0..1, different for each edge and seed.
double GuidedRun::seededShare(const SearchEdge& edge) const {
  const std::uint64_t mixed =
      (edge.firstSample + query_.seed * 0x9e3779b97f4a7c15ULL) * 0xbf58476d1ce4e5b9ULL;
  return static_cast<double>(mixed >> 40U) * 0x1.0p-24;
}

double GuidedRun::costToGo(const State& state) const {
  const double toGo = costToGo_.metres(state.via->to, state.placement);
  return end_.standing ? std::max(toGo, query_.tables.arrivals.leastMetres(state.via->to)) : toGo;
}

std::uint64_t GuidedRun::key(const State& state) const {
  const Vec2& at = state.placement.translation;
  const auto x = static_cast<std::uint64_t>(at.x() / stage_.cellMetres);
  const auto z = static_cast<std::uint64_t>(at.y() / stage_.cellMetres);
  const auto turn =
      static_cast<std::uint64_t>(quarterTurns(state.placement.heading) * 0.25 * stage_.headingCells);
  return ((state.via->to * 0x4000ULL + x) * 0x4000ULL + z) * 0x100ULL + turn;
}

bool GuidedRun::outOfTime(std::uint64_t expansions) const {
  return query_.outOfTime && expansions % kExpansionsBetweenTimeChecks == 0 && query_.outOfTime();
}

MotionPath GuidedRun::pathTo(std::uint32_t id) const {
  std::vector<std::uint32_t> chain;
  for (std::uint32_t at = id; at != kNone; at = states_[at].parent) chain.push_back(at);
  MotionPath path;
  path.start = {query_.start.position, startOf_[chain.back()]};
  for (auto it = chain.rbegin(); it != chain.rend(); ++it) {
    const State& state = states_[*it];
    if (state.via != nullptr) appendWay(query_.tables.graph, *state.via, state.goalSample, path.steps);
  }
  for (std::uint32_t a = states_[id].arrival; a != kNone; a = query_.tables.arrivals[a].next) {
    const SearchEdge& edge = query_.tables.graph.edges()[query_.tables.arrivals[a].edge];
    const bool last = query_.tables.arrivals[a].next == kNone;
    appendWay(query_.tables.graph, edge, last ? edge.settledSample : kNone, path.steps);
  }
  return path;
}

}  // namespace stridegraph
