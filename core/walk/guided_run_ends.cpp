#include "walk/guided_run.h"

#include <algorithm>

// How walks end: where ends are seen, which will do, and what leads there.

namespace stridegraph {
namespace {

/// Arrivals looked at for one state: the cheapest that end at the goal.
constexpr std::size_t kArrivalsTried = 6;
constexpr std::size_t kArrivalsOpened = 2;

/// What each metre by which an end misses the goal counts for: those that have to be bent less come first.
constexpr double kMissCost = 2.0;

/// Ends looked at before the first is taken though it is not accepted, or none.
constexpr std::size_t kEndsTried = 80;

/// An end is judged by so many metres before it, more than would be bent.
constexpr double kJudgedMetres = 9.0;

/// Appends a way as far as it has so many samples.
void appendWay(const SearchGraph& graph, const SearchEdge& way, std::uint32_t samples,
               std::vector<WalkStep>& steps) {
  std::uint32_t left = samples;
  for (WalkStep step : graph.stepsOf(way)) {
    step.end = step.begin + std::min(step.end - step.begin, left);
    left -= step.end - step.begin;
    if (step.end > step.begin) steps.push_back(step);
  }
}

}  // namespace

/// Whether the end of a walk will do: judged by its last metres.
bool GuidedRun::isAccepted(std::uint32_t id) const {
  if (!query_.accepts) return true;
  const Vec2& end = states_[id].placement.translation;
  std::uint32_t from = states_[id].parent;
  while (from != kNone && (states_[from].placement.translation - end).norm() < kJudgedMetres)
    from = states_[from].parent;
  const std::uint32_t begun = query_.onward ? query_.onward->frame : 0;
  return query_.accepts(pathTo(id, from), from == kNone ? begun : states_[from].frame);
}

/// Looks at an end; whether to look no further.
bool GuidedRun::tryEnd(std::uint32_t id) {
  const bool accepted = isAccepted(id);
  if (accepted || (!end_.bent && endsTried_ == 0)) take(id);
  return accepted || ++endsTried_ == kEndsTried;
}

void GuidedRun::take(std::uint32_t id) {
  const State& end = states_[id];
  result_.status = SearchStatus::kArrived;
  result_.path = pathTo(id, kNone);
  result_.costMetres = end.cost;
  result_.blendMetres = blendMetres(id);
  marks_.clear();
  for (std::uint32_t at = end.parent; at != kNone; at = states_[at].parent) {
    const State& state = states_[at];
    const double metres = field_.metresToGoal(state.placement.translation);
    if (!marks_.empty() && metres <= marks_.back().metresToGoal) continue;
    const double left = end.cost - state.cost;
    marks_.push_back({metres, left - costToGo_.estimate(state.node, state.placement)});
  }
}

/// For how much of what the walk to an end costs its transitions count.
double GuidedRun::blendMetres(std::uint32_t id) const {
  const WalkCost& cost = params_.cost;
  double metres = 0.0;
  for (std::uint32_t at = id; at != kNone; at = states_[at].parent) {
    const State& state = states_[at];
    if (state.via == nullptr) continue;
    metres += stage_.transitionFactor * state.shareOfVia() * cost.ofTransitions(*state.via);
  }
  query_.tables.arrivals.visitWays(query_.tables.graph, states_[id].arrival, [&](const ArrivalWay& way) {
    metres += cost.ofTransitions(way.edge) * way.share();
    return true;
  });
  return metres;
}

/// Opens the end of the walk on a way where one of its samples will do: the one nearest to the goal.
void GuidedRun::openEndOn(std::uint32_t parent, const State& from, const SearchEdge& edge) {
  const FloorTransform& placement = from.placement;
  const double reach = edge.lengthMetres + end_.radiusMetres;
  if ((placement.translation - query_.goal.position).squaredNorm() > reach * reach) return;
  if (end_.standing && edge.settledSample == kNone) return;
  const std::span<const Eigen::Vector2f> samples = query_.tables.graph.samplesOf(edge);
  const std::span<const Eigen::Vector2f> headings = query_.tables.graph.headingsOf(edge);
  double nearest = end_.radiusMetres;
  State end = from;
  end.node = kNone;
  end.via = &edge;
  end.parent = parent;
  const std::uint32_t first = end_.standing ? edge.settledSample : 0;
  const std::uint32_t last = end_.standing ? first : edge.sampleCount - 1;
  for (std::uint32_t s = first; s <= last; ++s) {
    const Vec2 point = placement * Vec2(samples[s].cast<double>());
    const double toGoal = (point - query_.goal.position).norm();
    if (toGoal >= nearest) continue;
    if (!facesGoal(placement.heading + Heading{double{headings[s].x()}, double{headings[s].y()}})) continue;
    nearest = toGoal;
    end.goalSample = s;
  }
  if (end.goalSample == kNone || from.frame + end.goalSample + 1 > lastFrame_) return;
  end.cost += kMissCost * nearest + costOf(placement, edge) * end.shareOfVia();
  open(end, 0.0);
}

/// Opens the cheapest ways from a state to a stand at the goal that are known and free.
void GuidedRun::openArrival(std::uint32_t parent, const State& state) {
  const ArrivalTable& arrivals = query_.tables.arrivals;
  const Vec2 toGoal = query_.goal.position - state.placement.translation;
  const double reach = arrivals.reachMetres() + end_.radiusMetres;
  if (toGoal.squaredNorm() > reach * reach) return;
  const FloorTransform nodeFromRoom = state.placement.inverse();
  std::size_t tried = 0;
  std::size_t opened = 0;
  for (const std::uint32_t id :
       arrivals.near(state.node, nodeFromRoom * query_.goal.position, end_.radiusMetres)) {
    const Arrival& arrival = arrivals[id];
    if (!facesGoal(state.placement.heading + arrival.end.heading)) continue;
    if (isFree(state.placement, state.frame, id)) {
      State end = state;
      const double miss = (state.placement * arrival.end.translation - query_.goal.position).norm();
      end.cost += arrival.costMetres + kMissCost * miss;
      if (wishes_) end.cost += wishes_->ofPace(query_.tables, id);
      end.node = kNone;
      end.via = nullptr;
      end.parent = parent;
      end.arrival = id;
      open(end, 0.0);
      if (++opened == kArrivalsOpened) return;
    }
    if (++tried == kArrivalsTried) return;
  }
}

bool GuidedRun::isFree(FloorTransform from, std::uint32_t frame, std::uint32_t arrival) {
  const SearchTables& tables = query_.tables;
  const bool free = tables.arrivals.visitWays(tables.graph, arrival, [&](const ArrivalWay& way) {
    if (frame + way.samples() > lastFrame_ || !isFree(from, frame, way.edge, way.samples())) return false;
    from = from * way.end();
    frame += way.samples();
    return true;
  });
  return free && mayStay(from.translation, frame);
}

/// Whether nobody who walks comes to a place where this one stands from a frame on.
bool GuidedRun::mayStay(const Vec2& place, std::uint32_t frame) {
  if (query_.traffic == nullptr || query_.traffic->staysClearOfBodies(place, frame)) return true;
  ++trouble_.atTraffic;
  return false;
}

bool GuidedRun::facesGoal(const Heading& heading) const {
  return goalCosine_ <= -1.0 || (heading - goalHeading_).cos >= goalCosine_;
}

/// The path to a state from another before it, or from the walk's beginning.
MotionPath GuidedRun::pathTo(std::uint32_t id, std::uint32_t from) const {
  std::vector<std::uint32_t> chain;
  for (std::uint32_t at = id; at != from; at = states_[at].parent) chain.push_back(at);
  MotionPath path;
  if (from != kNone) {
    path.start = states_[from].placement;
  } else {
    path.start = query_.onward ? query_.onward->placement
                               : FloorTransform{query_.start.position, startOf_[chain.back()]};
  }
  const SearchGraph& graph = query_.tables.graph;
  for (auto it = chain.rbegin(); it != chain.rend(); ++it) {
    const State& state = states_[*it];
    if (state.via == nullptr) continue;
    const std::uint32_t samples = state.goalSample == kNone ? state.via->sampleCount : state.goalSample + 1;
    appendWay(graph, *state.via, samples, path.steps);
  }
  query_.tables.arrivals.visitWays(graph, states_[id].arrival, [&](const ArrivalWay& way) {
    appendWay(graph, way.edge, way.samples(), path.steps);
    return true;
  });
  return path;
}

}  // namespace stridegraph
